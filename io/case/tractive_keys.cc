#include "io/case/key_declarations.h"

namespace tricontact::io {

namespace {

using contact::Case;
using Tractive = Case::TractiveRolling;

constexpr Range creepages{-1, 1};

}  // namespace

void add_tractive_keys(std::vector<CaseKey>& keys) {
    keys.push_back(
        {number_key("tractive_rolling.longitudinal_creepage", creepages, "0.002",
                    "creepage xi, slid over rolled way along x, instead of F_T",
                    {.alternative = tangential_load}),
         [](Case& c) { return in(c.tractive_rolling, &Tractive::longitudinal_creepage); }});
    keys.push_back(
        {number_key("tractive_rolling.lateral_creepage", creepages, "0.001",
                    "creepage eta, slid over rolled way along y; without it no lateral force"),
         [](Case& c) { return in(c.tractive_rolling, &Tractive::lateral_creepage); }});
    keys.push_back(
        {quantity_key("tractive_rolling.spin", Dimension::rotation_per_length, {-1e9, 1e9},
                      R"("0.5 rad/m")", "spin phi, rotation about the normal over rolled way",
                      {.default_value = R"("0 rad/m")"}),
         [](Case& c) { return in(c.tractive_rolling, &Tractive::spin); }});
    keys.push_back(
        {number_key("tractive_rolling.distance", above_zero(1000), "8",
                    "way rolled from rest, over the half length a of the contact on a half-space",
                    {.default_value = "8.0"}),
         [](Case& c) { return in(c.tractive_rolling, &Tractive::distance); }});
    keys.push_back(
        {quantity_key("tractive_rolling.speed", Dimension::velocity, above_zero(1e9),
                      R"("20 mm/s")", "speed v of rolling, which the substrate relaxes by",
                      {.required = true, .needs = "substrate.relaxation"}),
         [](Case& c) {
             return c.relaxation ? in(c.tractive_rolling, &Tractive::speed) : Field();
         }});
}

}  // namespace tricontact::io
