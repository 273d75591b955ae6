// The normal contact of a sphere: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"
#include "theory/hertz.h"

namespace tricontact::experiments {

namespace {

constexpr const char* hertz_source = "(2.1.8), (2.1.9)";

const ComparedQuantity quantities[] = {
    {"contact_radius", "a", "(3 F_N R/(4 E*))^(1/3), 1/E* = sum (1 - nu_i^2)/E_i", hertz_source,
     "m", [](const Values& x) { return hertz_of(x).contact_radius; },
     [](const Values& x) { return layer_of(x).contact_radius; }},
    {"indentation", "d", "a^2/R", hertz_source, "m",
     [](const Values& x) { return hertz_of(x).indentation; },
     [](const Values& x) { return layer_of(x).indentation; }},
    {"peak_pressure", "p_0", "3 F_N/(2 pi a^2)", hertz_source, "Pa",
     [](const Values& x) { return hertz_of(x).peak_pressure; },
     [](const Values& x) { return layer_of(x).centre_pressure; }},
    {"unit_shift", "U_max", "mu d E*/G* at mu = 1", hertz_source, "m",
     [](const Values& x) { return hertz_of(x).unit_shift; },
     [](const Values& x) { return *layer_of(x).unit_shift; }},
    {"normal_stiffness", "k_N", "2 E* a", hertz_source, "N/m",
     [](const Values& x) {
         return 2 * materials_of(x).effective_modulus() * hertz_of(x).contact_radius;
     },
     [](const Values& x) { return layer_of(x).normal_stiffness; }},
};

std::vector<Given> both_given(const Rig& rig) {
    std::vector<Given> result = contact_given(rig, hertz_keys);
    result.push_back(given(rig, "b").front());
    return result;
}

/// The layer's over the half-space's, of values in the order of both_given.
double ratio(const ComparedQuantity& q, const Values& x) {
    Values layer{x[0], x[1], x.back(), x[4], x[5]};
    if (x.size() > 7) layer.push_back(x[6]);
    return q.layer(layer) / q.half_space(x);
}

double ratio(const ComparedQuantity& q, const Rig& rig) {
    return ratio(q, values_of(both_given(rig)));
}

Formula thickness_formula(const Rig& rig) {
    return {"thickness_ratio",
            "b/D_c",
            rig.has("D_c") ? "b/D_c, D_c as measured" : "b/D_c, D_c = 2 a of Hertz",
            "(5.1.13)",
            "1",
            "b D_c",
            [](const Values& x) { return x[0] / x[1]; }};
}

/// E* by Hertz' formulas from what the layer shows, over the true one.
constexpr Formula modulus_factors[] = {
    Formula("modulus_from_indentation", "E_Hertz/E", "3 F_N/(4 sqrt(R) d^(3/2) E'), d of the layer",
            "Johnson (1985), ch. 4", "1", layer_keys,
            [](const Values& x) {
                return theory::hertz_modulus_from_indentation(x[1], x[0], layer_of(x).indentation) *
                       (1 - x[4] * x[4]) / x[3];
            }),
    Formula("modulus_from_contact_radius", "E_Hertz/E", "3 F_N R/(4 a^3 E'), a of the layer",
            "Johnson (1985), ch. 4", "1", layer_keys, [](const Values& x) {
                return theory::hertz_modulus_from_contact_radius(x[1], x[0],
                                                                 layer_of(x).contact_radius) *
                       (1 - x[4] * x[4]) / x[3];
            })};

/// Both diameters [m] beside the measured one.
std::string measured_sentence(const Rig& rig) {
    const double hertz = 2 * given(rig, "a").front().value.value,
                 layer = hertz * ratio(quantities[0], rig);
    const double size = rig["D_c"].value, error = rig["D_c"].standard_error;
    if (error == 0)
        return fmt::format(
            "The measured diameter of {}, whose error is not given, stands beside {} on the layer "
            "and {} by Hertz.",
            quantity(size, "m", 3), quantity(layer, "m", 3), quantity(hertz, "m", 3));
    const bool fits_hertz = std::abs(size - hertz) <= error;
    const bool fits_layer = std::abs(size - layer) <= error;
    const char* verdict = fits_hertz && fits_layer ? "does not distinguish the two"
                          : fits_layer             ? "fits the layer, not Hertz"
                          : fits_hertz             ? "fits Hertz, not the layer"
                                                   : "fits neither";
    const auto unit = contact::fitting_prefix(size);
    return fmt::format("The measured diameter of {} {}m {}: {} on the layer, {} by Hertz.",
                       with_error(size / unit.factor, error / unit.factor), unit.symbol, verdict,
                       quantity(layer, "m", 3), quantity(hertz, "m", 3));
}

std::string layer_sentences(const Rig& rig) {
    const auto beside = [&](std::size_t i) { return beside_hertz(ratio(quantities[i], rig)); };
    const std::string measured = rig.has("D_c") ? ' ' + measured_sentence(rig) : "";
    return fmt::format(
        "Indentation is {}: E from force and indentation would be {} times the true one. The "
        "stiffness is {} times Hertz', the peak pressure {}, the unit of shift {}. The contact "
        "radius is {}.{}",
        beside(1), significant(calculate(rig, modulus_factors[0]).result.value, 3),
        significant(ratio(quantities[4], rig), 3), beside(2), beside(3), beside(0), measured);
}

}  // namespace

Assumption half_space_assumption(const Rig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory) {
    using enum Criterion::Relation;
    Assumption a{
        .name = "half_space",
        .title = "Half-space",
        .claim = is_thesis_rig(rig) ? "The substrate is a half-space, since b >= D_c suffices"
                                    : "The substrate is a half-space",
        .criteria = {{std::move(thickness_ratio), at_least, 1,
                      "the rule of Wetter (2016), section 5.1.5: necessary, not sufficient"}}};
    const bool rigid = roller_is_rigid(rig);
    if (!rigid) a.missing = {theory_of_elastic_roller};
    a.consequence = rigid ? theory.consequence(rig)
                          : "The roller is not rigid beside the substrate, as the layer's theory "
                            "takes it: the two contacts are not compared.";
    for (const ComparedQuantity& q : compared) {
        a.background.push_back(calculate(q.name, q.symbol, q.formula, q.source, q.unit,
                                         contact_given(rig, hertz_keys), q.half_space));
        if (!rigid) continue;
        a.criteria.push_back(
            {calculate(std::string(q.name) + "_difference",
                       fmt::format("|{0} layer/{0} Hertz - 1|", q.symbol),
                       "the layer's over the half-space's, from the same data", theory.source, "1",
                       both_given(rig), [&q](const auto& x) { return std::abs(ratio(q, x) - 1); }),
             at_most, accepted_difference, accepted_reason});
        a.background.push_back(calculate(
            std::string("layer_") + q.name, std::string(q.symbol) + ", layer", theory.formula,
            theory.source, q.unit, contact_given(rig, layer_keys), q.layer));
    }
    return a;
}

Assumption half_space(const Rig& rig) {
    Assumption a = half_space_assumption(rig, calculate(rig, thickness_formula(rig)), quantities,
                                         {"Fredholm equation", exact_layer, layer_sentences});
    if (roller_is_rigid(rig))
        for (const Formula& factor : modulus_factors)
            a.background.push_back(calculate(rig, factor));
    return a;
}

}  // namespace tricontact::experiments
