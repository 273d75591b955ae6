#include "comparisons/quantities/quantities.h"
#include "comparisons/strength/body_strength.h"

namespace tricontact::comparisons::quantities {

namespace {

/// What `get` makes of the strength at the largest loads of the run; of its loads in any case.
template <auto get>
QuantityValue of_loads(const Subject& s) {
    const auto strength = strength_of(s.c, largest_loads(s.c, s.history));
    return strength ? finite(get(*strength)) : QuantityValue();
}
template <auto get>
QuantityValue of_strengths(const Subject& s) {
    const auto strength = strength_of(s.c, largest_loads(s.c, s.history));
    return strength && strength->is_known() ? finite(get(*strength)) : QuantityValue();
}

using Value = std::optional<double>;

constexpr const char* with_yield_stress =
    "where a body has a yield stress and no edge of the contact slips backward under a bulk stress";
constexpr const char* with_yield_or_bulk_stress =
    "of smooth spheres and cylinders on a half-space with a yield or bulk stress";
constexpr const char* of_cylinders =
    "of cylinders with a yield or bulk stress, where no edge of the contact slips backward";

Value peak(const Strength& s, double theory::StressPeak::*member) {
    return s.weakest() ? Value(s.weakest()->peak.*member) : std::nullopt;
}

constinit const Quantity von_mises{
    .key = "strength_von_mises_Pa",
    .unit = "Pa",
    .name = "von Mises stress of the body that yields first",
    .meaning =
        "Largest von Mises stress in the body that yields first, at the largest forces of the run.",
    .defined = with_yield_stress,
    .source = "Johnson (1985), Hamilton and Goodman (1966)",
    .of = of_strengths<[](const Strength& s) { return peak(s, &theory::StressPeak::von_mises); }>,
    .place = "/strength/von_mises_Pa",
    .part = Part::inside};

constinit const Quantity depth{
    .key = "strength_depth_m",
    .unit = "m",
    .name = "depth of first yield",
    .meaning = "Depth at which the weaker body yields first; 0 at its surface.",
    .defined = with_yield_stress,
    .of = of_strengths<[](const Strength& s) { return peak(s, &theory::StressPeak::depth); }>,
    .place = "/strength/depth_m",
    .part = Part::inside,
    .is_place = true};

constinit const Quantity pressure_over_k{
    .key = "strength_pressure_over_k",
    .symbol = "p_0/k",
    .name = "peak pressure over the shear yield stress",
    .meaning = "Hertz' peak pressure over the least shear yield stress k = Y/sqrt(3).",
    .defined = with_yield_stress,
    .of = of_strengths<[](const Strength& s) { return s.pressure_over_k(); }>,
    .place = "/strength/pressure_over_k",
    .part = Part::inside};

constinit const Quantity shakedown_pressure{
    .key = "strength_shakedown_over_k",
    .name = "limit of elastic shakedown of p_0/k",
    .meaning =
        "Largest p_0/k at which the material shakes down under a line contact that slides over it "
        "again and again with the friction mu.",
    .defined = "of cylinders with a yield stress",
    .source = "Johnson (1985), section 9.2; Ponter, Hearle and Johnson (1985)",
    .of = of_strengths<[](const Strength& s) { return s.shakedown_pressure; }>,
    .place = "/strength/shakedown_over_k",
    .part = Part::inside};

constinit const Quantity stick_centre{
    .key = "strength_stick_centre_m",
    .symbol = "e",
    .unit = "m",
    .name = "centre of the stick zone under a bulk stress",
    .meaning =
        "By closed form, from the contact's centre, along x; of a sphere exact at nu = 0, within 3 "
        "% "
        "at 0.3.",
    .defined = with_yield_or_bulk_stress,
    .source = "Nowell and Hills (1987)",
    .of = of_strengths<[](const Strength& s) { return Value(s.stick_centre); }>,
    .place = "/strength/stick_centre_m",
    .is_place = true};

}  // namespace

constinit const Quantity strength_normal_force{
    .key = "strength_normal_force_N",
    .symbol = "F_N",
    .unit = "N",
    .name = "largest normal force",
    .meaning = "Largest normal force of the run, by which strength is judged.",
    .defined = with_yield_or_bulk_stress,
    .of = of_loads<[](const Strength& s) { return Value(s.loads.normal_force); }>,
    .place = "/strength/normal_force_N"};

constinit const Quantity strength_tangential_force{
    .key = "strength_tangential_force_N",
    .symbol = "F_T",
    .unit = "N",
    .name = "largest tangential force",
    .meaning = "Tangential force of the largest magnitude in the run, by which strength is judged.",
    .defined = with_yield_or_bulk_stress,
    .of = of_loads<[](const Strength& s) { return Value(s.loads.tangential_force); }>,
    .place = "/strength/tangential_force_N"};

constinit const Quantity strength_bulk_stress{
    .key = "strength_bulk_stress_Pa",
    .unit = "Pa",
    .name = "bulk stress",
    .meaning = "Bulk stress of the substrate that acts together with this tangential force.",
    .defined = with_yield_or_bulk_stress,
    .of = of_loads<[](const Strength& s) { return Value(s.loads.bulk_stress); }>,
    .place = "/strength/bulk_stress_Pa"};

constinit const Quantity yield_factor{
    .key = "yield_factor",
    .name = "stresses of first yield over those of the run",
    .meaning =
        "Factor on all stresses at the largest forces of the run at which a body begins to yield, "
        "by von Mises; below 1 it yields.",
    .defined = with_yield_stress,
    .source = "Johnson (1985), Hamilton and Goodman (1966)",
    .of = of_strengths<[](const Strength& s) {
        return s.weakest() ? Value(s.weakest()->factor()) : std::nullopt;
    }>,
    .place = "/strength/yield_factor",
    .part = Part::inside,
    .is_plotted = true};

constinit const Quantity first_yield_force{
    .key = "first_yield_force_N",
    .unit = "N",
    .name = "normal force of first yield",
    .meaning = "Normal force at which a body begins to yield, the tangential force in proportion.",
    .defined = "where a body has a yield stress, without a bulk stress",
    .source = "Johnson (1985), Hamilton and Goodman (1966)",
    .of = of_strengths<[](const Strength& s) { return s.first_yield_force(); }>,
    .place = "/strength/first_yield_force_N",
    .part = Part::inside};

constinit const Quantity trailing_stress{
    .key = "trailing_stress_Pa",
    .symbol = "sigma_xx",
    .unit = "Pa",
    .name = "stress at the trailing edge",
    .meaning =
        "Stress along x in the surface of the substrate at the edge of the contact that the "
        "tangential force on it points away from, tension positive.",
    .defined = of_cylinders,
    .source = "Nowell and Hills (1987), Johnson (1985)",
    .of = of_strengths<[](const Strength& s) {
        return s.line ? Value(s.line->trailing_stress()) : std::nullopt;
    }>,
    .place = "/strength/trailing_stress_Pa",
    .part = Part::inside};

List of_strength() {
    return {&strength_normal_force,
            &strength_tangential_force,
            &strength_bulk_stress,
            &yield_factor,
            &first_yield_force,
            &von_mises,
            &depth,
            &pressure_over_k,
            &shakedown_pressure,
            &stick_centre,
            &trailing_stress};
}

}  // namespace tricontact::comparisons::quantities
