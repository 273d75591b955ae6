// The normal contact of a sphere: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "experiments/assumptions/rolling_parts.h"
#include "theory/hertz.h"

namespace tricontact::experiments {

namespace {

using contact::quantity;
using contact::Sentence;
using contact::significant;
using theory::LayerContact;
using Values = std::vector<double>;

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

std::vector<Given> both_given(const RollingRig& rig) {
    return with(contact_given(rig, hertz_given(rig)), {"b", rig.substrate.thickness, "m"});
}

/// The layer's over the half-space's, of values in the order of both_given.
double ratio(const ComparedQuantity& q, const Values& x) {
    Values layer{x[0], x[1], x.back(), x[4], x[5]};
    if (x.size() > 7) layer.push_back(x[6]);
    return q.layer(layer) / q.half_space(x);
}

double ratio(const ComparedQuantity& q, const RollingRig& rig) {
    return ratio(q, values_of(both_given(rig)));
}

Calculation thickness_ratio(const RollingRig& rig) {
    const auto measured = rig.measured_contact_size;
    return calculate("thickness_ratio", "b/D_c",
                     measured ? "b/D_c, D_c as measured" : "b/D_c, D_c = 2 a of Hertz", "(5.1.13)",
                     "1",
                     {{"b", rig.substrate.thickness, "m"},
                      {"D_c", measured.value_or(statistics::Uncertain{2 * half_size(rig)}), "m"}},
                     [](const auto& x) { return x[0] / x[1]; });
}

// E* by Hertz' formulas from what the layer shows, over the true one.
Calculation modulus_factor(const RollingRig& rig, bool from_indentation) {
    return calculate(
        from_indentation ? "modulus_from_indentation" : "modulus_from_contact_radius", "E_Hertz/E",
        from_indentation ? "3 F_N/(4 sqrt(R) d^(3/2) E'), d of the layer"
                         : "3 F_N R/(4 a^3 E'), a of the layer",
        "Johnson (1985), ch. 4", "1", layer_given(rig), [from_indentation](const auto& x) {
            const LayerContact layer = layer_of(x);
            const double found =
                from_indentation
                    ? theory::hertz_modulus_from_indentation(x[1], x[0], layer.indentation)
                    : theory::hertz_modulus_from_contact_radius(x[1], x[0], layer.contact_radius);
            return found * (1 - x[4] * x[4]) / x[3];
        });
}

/// The contact of a rig, by both theories where both hold.
struct Subject {
    const RollingRig& rig;
    bool rigid = roller_is_rigid(rig);
};

bool rigid(const Subject& s) {
    return s.rigid;
}
bool not_rigid(const Subject& s) {
    return !s.rigid;
}
bool measured(const Subject& s) {
    return s.rigid && s.rig.measured_contact_size.has_value();
}
bool measured_with_error(const Subject& s) {
    return measured(s) && s.rig.measured_contact_size->standard_error > 0;
}
bool measured_without_error(const Subject& s) {
    return measured(s) && !measured_with_error(s);
}

std::string layer_sentence(const Subject& s) {
    const auto beside = [&](std::size_t i) { return beside_hertz(ratio(quantities[i], s.rig)); };
    return fmt::format(
        "Indentation is {}: E from force and indentation would be {} times the true one. The "
        "stiffness is {} times Hertz', the peak pressure {}, the unit of shift {}. The contact "
        "radius is {}.",
        beside(1), significant(modulus_factor(s.rig, true).result.value, 3),
        significant(ratio(quantities[4], s.rig), 3), beside(2), beside(3), beside(0));
}

std::string measured_sentence(const Subject& s) {
    const double hertz = 2 * half_size(s.rig), layer = hertz * ratio(quantities[0], s.rig);
    const auto [size, error] = *s.rig.measured_contact_size;
    const bool fits_hertz = std::abs(size - hertz) <= error;
    const bool fits_layer = std::abs(size - layer) <= error;
    const char* verdict = fits_hertz && fits_layer ? "cannot tell the two apart"
                          : fits_layer             ? "fits the layer, not Hertz"
                          : fits_hertz             ? "fits Hertz, not the layer"
                                                   : "fits neither";
    const auto unit = contact::fitting_prefix(size);
    return fmt::format("The measured diameter of {} {}m {}: {} on the layer, {} by Hertz.",
                       contact::with_error(size / unit.factor, error / unit.factor), unit.symbol,
                       verdict, quantity(layer, "m", 3), quantity(hertz, "m", 3));
}

std::string unjudged_sentence(const Subject& s) {
    const double hertz = 2 * half_size(s.rig);
    return fmt::format(
        "The measured diameter of {}, whose error is not given, stands beside {} on the layer and "
        "{} by Hertz.",
        quantity(s.rig.measured_contact_size->value, "m", 3),
        quantity(hertz * ratio(quantities[0], s.rig), "m", 3), quantity(hertz, "m", 3));
}

std::string elastic_roller_sentence(const Subject& /*s*/) {
    return "The roller is not rigid beside the substrate, as the layer's theory takes it: the two "
           "contacts are not compared.";
}

constexpr Sentence<Subject> sentences[] = {{rigid, layer_sentence},
                                           {measured_with_error, measured_sentence},
                                           {measured_without_error, unjudged_sentence},
                                           {not_rigid, elastic_roller_sentence}};

}  // namespace

std::vector<Given> contact_given(const RollingRig& rig, std::vector<Given> given) {
    if (rig.roller.shape == RollingRig::Shape::sphere) return given;
    return with_length(std::move(given), rig);
}

Assumption half_space_assumption(const RollingRig& rig, Calculation thickness_ratio,
                                 std::span<const ComparedQuantity> compared,
                                 const LayerTheory& theory, std::string consequence) {
    using enum Criterion::Relation;
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = is_thesis_rig(rig)
                              ? "The substrate is a half-space, since b >= D_c suffices"
                              : "The substrate is a half-space",
                 .criteria = {{std::move(thickness_ratio), at_least, 1,
                               "the rule of Wetter (2016), section 5.1.5: necessary, not "
                               "sufficient"}},
                 .consequence = std::move(consequence)};
    const bool rigid = roller_is_rigid(rig);
    if (!rigid) a.missing = {theory_of_elastic_roller};
    for (const ComparedQuantity& q : compared) {
        a.background.push_back(calculate(q.name, q.symbol, q.formula, q.source, q.unit,
                                         contact_given(rig, hertz_given(rig)), q.half_space));
        if (!rigid) continue;
        a.criteria.push_back(
            {calculate(std::string(q.name) + "_difference",
                       fmt::format("|{0} layer/{0} Hertz - 1|", q.symbol),
                       "the layer's over the half-space's, from the same data", theory.source, "1",
                       both_given(rig), [&q](const auto& x) { return std::abs(ratio(q, x) - 1); }),
             at_most, accepted_difference, accepted_reason});
        a.background.push_back(calculate(
            std::string("layer_") + q.name, std::string(q.symbol) + ", layer", theory.formula,
            theory.source, q.unit, contact_given(rig, layer_given(rig)), q.layer));
    }
    return a;
}

Assumption half_space(const RollingRig& rig) {
    Assumption a = half_space_assumption(rig, thickness_ratio(rig), quantities,
                                         {"Fredholm equation", "exact contact with a bonded layer"},
                                         told(sentences, Subject{rig}));
    if (roller_is_rigid(rig))
        for (const bool from_indentation : {true, false})
            a.background.push_back(modulus_factor(rig, from_indentation));
    return a;
}

}  // namespace tricontact::experiments
