#include "io/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Kind = Key::Kind;
using Tractive = Case::TractiveRolling;

constexpr Range creepages{-1, 1};

}  // namespace

void add_tractive_keys(std::vector<CaseKey>& keys) {
    keys.push_back(
        {{.path = "tractive_rolling.longitudinal_creepage",
          .kind = Kind::number,
          .range = creepages,
          .alternative = tangential_load,
          .example = "0.002",
          .text = "creepage xi, slid over rolled way along x, instead of F_T"},
         [](Case& c) { return in(c.tractive_rolling, &Tractive::longitudinal_creepage); }});
    keys.push_back(
        {{.path = "tractive_rolling.lateral_creepage",
          .kind = Kind::number,
          .range = creepages,
          .example = "0.001",
          .text = "creepage eta, slid over rolled way along y; without it no lateral force"},
         [](Case& c) { return in(c.tractive_rolling, &Tractive::lateral_creepage); }});
    keys.push_back({{.path = "tractive_rolling.spin",
                     .kind = Kind::quantity,
                     .dimension = Dimension::rotation_per_length,
                     .range = {-1e9, 1e9},
                     .default_value = R"("0 rad/m")",
                     .example = R"("0.5 rad/m")",
                     .text = "spin phi, rotation about the normal over rolled way"},
                    [](Case& c) { return in(c.tractive_rolling, &Tractive::spin); }});
    keys.push_back(
        {{.path = "tractive_rolling.distance",
          .kind = Kind::number,
          .range = above_zero(1000),
          .default_value = "8.0",
          .example = "8",
          .text = "way rolled from rest, over the half length a of the contact on a half-space"},
         [](Case& c) { return in(c.tractive_rolling, &Tractive::distance); }});
    keys.push_back({{.path = "tractive_rolling.speed",
                     .kind = Kind::quantity,
                     .dimension = Dimension::velocity,
                     .range = above_zero(1e9),
                     .required = true,
                     .needs = "substrate.relaxation",
                     .example = R"("20 mm/s")",
                     .text = "speed v of rolling, which the substrate relaxes by"},
                    [](Case& c) {
                        return c.relaxation ? in(c.tractive_rolling, &Tractive::speed) : Field();
                    }});
}

}  // namespace tricontact::io
