// The normal contact of a sphere: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "rig/rolling_formulas.h"
#include "rig/rolling_parts.h"
#include "rig/thesis_rigs.h"
#include "theory/hertz.h"

namespace tricontact::rig {

namespace {

using contact::HalfSpaceScales;
using contact::quantity;
using contact::RollingRig;
using contact::Sentence;
using contact::significant;
using theory::LayerContact;

constexpr const char* hertz_source = "(2.1.8), (2.1.9)";
constexpr const char* layer_source = "exact contact with a bonded layer";

/// One quantity of the contact, by both theories.
struct Quantity {
    const char* name;
    const char* symbol;
    const char* unit;
    const char* hertz_formula;
    double (*hertz)(const HalfSpaceScales&, const contact::MaterialPair&);
    double (*layer)(const LayerContact&);
};

const Quantity quantities[] = {
    {"contact_radius", "a", "m", "(3 F_N R/(4 E*))^(1/3), 1/E* = sum (1 - nu_i^2)/E_i",
     [](const HalfSpaceScales& h, const contact::MaterialPair&) { return h.contact_radius; },
     [](const LayerContact& l) { return l.contact_radius; }},
    {"indentation", "d", "m", "a^2/R",
     [](const HalfSpaceScales& h, const contact::MaterialPair&) { return h.indentation; },
     [](const LayerContact& l) { return l.indentation; }},
    {"peak_pressure", "p_0", "Pa", "3 F_N/(2 pi a^2)",
     [](const HalfSpaceScales& h, const contact::MaterialPair&) { return h.peak_pressure; },
     [](const LayerContact& l) { return l.centre_pressure; }},
    {"unit_shift", "U_max", "m", "mu d E*/G* at mu = 1",
     [](const HalfSpaceScales& h, const contact::MaterialPair&) { return h.unit_shift; },
     [](const LayerContact& l) { return *l.unit_shift; }},
    {"normal_stiffness", "k_N", "N/m", "2 E* a",
     [](const HalfSpaceScales& h, const contact::MaterialPair& m) {
         return 2 * m.effective_modulus() * h.contact_radius;
     },
     [](const LayerContact& l) { return l.normal_stiffness; }},
};

double hertz_value(const Quantity& q, const std::vector<double>& x) {
    return q.hertz(hertz_of(x), materials_of(x));
}

// Of the order of hertz_given and a thickness behind.
double layer_value(const Quantity& q, const std::vector<double>& x) {
    return q.layer(layer_of({x[0], x[1], x[6], x[4], x[5]}));
}

Calculation on_half_space(const Quantity& q, const RollingRig& rig) {
    return calculate({.name = q.name,
                      .symbol = q.symbol,
                      .formula = q.hertz_formula,
                      .source = hertz_source,
                      .unit = q.unit,
                      .given = hertz_given(rig),
                      .function = [&q](const auto& x) { return hertz_value(q, x); },
                      .result = {}});
}

Calculation on_layer(const Quantity& q, const RollingRig& rig) {
    return calculate({.name = std::string("layer_") + q.name,
                      .symbol = std::string(q.symbol) + ", layer",
                      .formula = "Fredholm equation",
                      .source = layer_source,
                      .unit = q.unit,
                      .given = layer_given(rig),
                      .function = [&q](const auto& x) { return q.layer(layer_of(x)); },
                      .result = {}});
}

Calculation difference(const Quantity& q, const RollingRig& rig) {
    return calculate(
        {.name = std::string(q.name) + "_difference",
         .symbol = fmt::format("|{0} layer/{0} Hertz - 1|", q.symbol),
         .formula = "the layer's over the half-space's, from the same data",
         .source = layer_source,
         .unit = "1",
         .given = with(hertz_given(rig), {"b", rig.substrate.thickness, "m"}),
         .function =
             [&q](const auto& x) { return std::abs(layer_value(q, x) / hertz_value(q, x) - 1); },
         .result = {}});
}

Calculation thickness_ratio(const RollingRig& rig) {
    const auto measured = rig.measured_contact_size;
    return calculate(
        {.name = "thickness_ratio",
         .symbol = "b/D_c",
         .formula = measured ? "b/D_c, D_c as measured" : "b/D_c, D_c = 2 a of Hertz",
         .source = "(5.1.13)",
         .unit = "1",
         .given = {{"b", rig.substrate.thickness, "m"},
                   {"D_c", measured.value_or(theory::Uncertain{2 * half_size(rig)}), "m"}},
         .function = [](const auto& x) { return x[0] / x[1]; },
         .result = {}});
}

// E* by Hertz' formulas from what the layer shows, over the true one.
Calculation modulus_factor(const RollingRig& rig, bool from_indentation) {
    return calculate(
        {.name = from_indentation ? "modulus_from_indentation" : "modulus_from_contact_radius",
         .symbol = "E_Hertz/E",
         .formula = from_indentation ? "3 F_N/(4 sqrt(R) d^(3/2) E'), d of the layer"
                                     : "3 F_N R/(4 a^3 E'), a of the layer",
         .source = "Johnson (1985), ch. 4",
         .unit = "1",
         .given = layer_given(rig),
         .function =
             [from_indentation](const auto& x) {
                 const LayerContact layer = layer_of(x);
                 const double found = from_indentation ? theory::hertz_modulus_from_indentation(
                                                             x[1], x[0], layer.indentation)
                                                       : theory::hertz_modulus_from_contact_radius(
                                                             x[1], x[0], layer.contact_radius);
                 return found * (1 - x[4] * x[4]) / x[3];
             },
         .result = {}});
}

double ratio(const Quantity& q, const RollingRig& rig) {
    const auto x = values_of(with(hertz_given(rig), {"b", rig.substrate.thickness, "m"}));
    return layer_value(q, x) / hertz_value(q, x);
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
    return "The roller is not rigid beside the substrate, as the layer's theory takes it: the "
           "two contacts are not compared.";
}

constexpr Sentence<Subject> sentences[] = {{rigid, layer_sentence},
                                           {measured_with_error, measured_sentence},
                                           {measured_without_error, unjudged_sentence},
                                           {not_rigid, elastic_roller_sentence}};

}  // namespace

Criterion thick_enough(Calculation thickness_ratio) {
    return {std::move(thickness_ratio), Criterion::Relation::at_least, 1,
            "the rule of Wetter (2016), section 5.1.5: necessary, not sufficient"};
}

std::string half_space_claim(const RollingRig& rig) {
    return is_thesis_rig(rig) ? "The substrate is a half-space, since b >= D_c suffices"
                              : "The substrate is a half-space";
}

Assumption half_space(const RollingRig& rig) {
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = half_space_claim(rig),
                 .criteria = {thick_enough(thickness_ratio(rig))},
                 .background = {},
                 .missing = {},
                 .consequence = told(sentences, Subject{rig})};
    const bool compared = roller_is_rigid(rig);
    if (!compared) a.missing = {theory_of_elastic_roller};
    for (const Quantity& q : quantities) {
        a.background.push_back(on_half_space(q, rig));
        if (!compared) continue;
        a.criteria.push_back({difference(q, rig), Criterion::Relation::at_most, accepted_difference,
                              accepted_reason});
        a.background.push_back(on_layer(q, rig));
    }
    if (compared)
        for (const bool from_indentation : {true, false})
            a.background.push_back(modulus_factor(rig, from_indentation));
    return a;
}

}  // namespace tricontact::rig
