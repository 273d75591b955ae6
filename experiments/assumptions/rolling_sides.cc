// Whether the layer is wide enough for its sides not to be felt.
#include <fmt/format.h>

#include <algorithm>

#include "experiments/assumptions/rolling_parts.h"
#include "theory/layer/free_sides.h"

namespace tricontact::experiments {

namespace {

constexpr const char* distance_text =
    "(distance of the nearest side from the centre - a)/a, at the furthest point of rolling";
constexpr const char* block_text =
    "q 1.15 F_N/(G_2 b d) S(a/b)^2 times the mean over directions of phi(rho/b), phi ~ exp(-2 "
    "lambda rho/b); q: what the effect is of this upper estimate";
constexpr const char* strip_text =
    "q 1.25 F_N/(L G_2 d) S(a/b)^2 times the mean over both sides of phi(rho/b), phi ~ exp(-2 "
    "lambda rho/b); q: what the effect is of this upper estimate";
constexpr const char* effect_source =
    "decay by Williams (1952), amplitudes by finite elements: theory/layer/free_sides.h";

// From all of the estimate down to what its excess leaves.
constexpr double least_share = 1 / theory::largest_side_excess;
constexpr Estimate share_of_estimate{(1 + least_share) / 2, (1 - least_share) / 2};

/// At the furthest point of rolling.
theory::BlockSides block_of(const RigData& r) {
    return {r.l_x / 2 - r.W_x, r.l_x / 2 + r.W_x, r.l_y / 2 - r.W_y, r.l_y / 2 + r.W_y};
}

/// Of a sphere's block and a cylinder's strip, and the upper estimate.
struct SideForms {
    Formula distance;
    const char* effect_text;
    double (*estimate)(const RigData&);
};

constexpr SideForms of_block{
    {"side_distance", "s/a", distance_text, exact_layer, "1",
     layer_inputs + Inputs{&Rig::l_x, &Rig::W_x, &Rig::l_y, &Rig::W_y},
     [](const RigData& r) {
         const theory::BlockSides sides = block_of(r);
         return std::min(sides.right, sides.front) / layer_of(r).contact_radius - 1;
     }},
    block_text,
    [](const RigData& r) { return theory::side_effect(layer_with(r), layer_of(r), block_of(r)); }};
constexpr SideForms of_strip{
    {"side_distance", "s/a", distance_text, exact_layer, "1",
     layer_inputs + Inputs{&Rig::l_x, &Rig::W_x},
     [](const RigData& r) { return (r.l_x / 2 - r.W_x) / layer_line_of(r).half_width - 1; }},
    strip_text,
    [](const RigData& r) {
        return theory::side_effect(layer_with(r), layer_line_of(r), r.l_x / 2 - r.W_x,
                                   r.l_x / 2 + r.W_x);
    }};

Calculation effect_of_sides(const Rig& rig, const SideForms& forms) {
    Rig estimated = rig;
    estimated.q = share_of_estimate;
    return calculate(estimated, "side_effect", "Delta d/d", forms.effect_text, effect_source, "1",
                     forms.distance.given + Inputs{&Rig::q},
                     [estimate = forms.estimate](const RigData& r) { return r.q * estimate(r); });
}

/// Where the estimate of the effect is not known to be one; empty where it is.
std::string out_of_estimate(const Rig& rig, double side_distance) {
    if (rig.nu_2 < theory::least_side_poisson)
        return fmt::format("an estimate for nu_2 below {}", theory::least_side_poisson);
    if (side_distance < theory::nearest_side)
        return fmt::format("an estimate for sides closer than {} a to the contact",
                           theory::nearest_side);
    return {};
}

}  // namespace

Assumption far_edges(const Rig& rig) {
    using enum Criterion::Relation;
    Assumption a{.name = "far_edges",
                 .title = "Unbounded layer",
                 .claim = "The layer is unbounded: its sides are too far away to be felt"};
    const SideForms& forms = rig.kind == Rig::Kind::cylinder ? of_strip : of_block;
    if (!roller_is_rigid(rig)) {
        a.missing = {theory_of_elastic_roller};
        return a;
    }
    if (!decide(a, rig, forms.distance, at_least, 0, "beyond it the contact is not on the layer"))
        return a;
    const double side_distance = a.deciding_value();
    if (side_distance < 0) {
        a.consequence = "Rolled to its furthest point, the contact leaves the layer.";
        return a;
    }
    if (std::string why = out_of_estimate(rig, side_distance); !why.empty()) {
        a.missing = {std::move(why)};
        return a;
    }
    a.criteria.push_back(
        {effect_of_sides(rig, forms), at_most, accepted_difference, accepted_reason});
    const double estimate = a.criteria.back().calculation.result.value / share_of_estimate.value;
    a.consequence = fmt::format(
        "At the furthest point of rolling the nearest side is {} contact radii from the contact; "
        "free sides add {} to the indentation.{}",
        significant(side_distance, 2),
        a.standing() == Standing::holds
            ? "at most " + percent_text(estimate, 2)
            : significant(100 * least_share * estimate, 2) + " to " + percent_text(estimate, 2),
        a.standing() == Standing::holds ? "" : " fem with substrate.width and depth computes it.");
    return a;
}

}  // namespace tricontact::experiments
