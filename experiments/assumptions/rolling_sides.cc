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

/// Of values in the order R F_N b E_2 nu_2 l_x W_x l_y W_y.
theory::BlockSides block_of(const Values& x) {
    return {x[5] / 2 - x[6], x[5] / 2 + x[6], x[7] / 2 - x[8], x[7] / 2 + x[8]};
}

theory::ElasticLayer layer_with_sides(const Values& x) {
    return {{x[3], x[4]}, x[2], theory::LayerBase::bonded};
}

constexpr const char* block_keys = "R F_N b E_2 nu_2 l_x W_x l_y W_y";
constexpr const char* strip_keys = "R F_N b E_2 nu_2 L l_x W_x";

/// Of a sphere's block and a cylinder's strip, the upper estimate of values in this order.
struct SideForms {
    Formula distance;
    const char* effect_text;
    double (*estimate)(const Values&);
};

constexpr SideForms of_block{
    {"side_distance", "s/a", distance_text, exact_layer, "1", block_keys,
     [](const Values& x) {
         const theory::BlockSides sides = block_of(x);
         return std::min(sides.right, sides.front) / layer_of(x).contact_radius - 1;
     }},
    block_text,
    [](const Values& x) {
        return theory::side_effect(layer_with_sides(x), layer_of(x), block_of(x));
    }};
constexpr SideForms of_strip{
    {"side_distance", "s/a", distance_text, exact_layer, "1", strip_keys,
     [](const Values& x) { return (x[6] / 2 - x[7]) / layer_line_of(x).half_width - 1; }},
    strip_text,
    [](const Values& x) {
        return theory::side_effect(layer_with_sides(x), layer_line_of(x), x[6] / 2 - x[7],
                                   x[6] / 2 + x[7]);
    }};

Calculation effect_of_sides(const Rig& rig, const SideForms& forms) {
    std::vector<Given> values = given(rig, forms.distance.given);
    values.push_back({"q", share_of_estimate, "1"});
    return calculate(
        "side_effect", "Delta d/d", forms.effect_text, effect_source, "1", std::move(values),
        [estimate = forms.estimate](const Values& x) { return x.back() * estimate(x); });
}

/// Where the estimate of the effect is not known to be one; empty where it is.
std::string out_of_estimate(const Rig& rig, double side_distance) {
    if (rig["nu_2"].value < theory::least_side_poisson)
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
