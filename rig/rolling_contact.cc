// The normal contact of a sphere: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "rig/rolling_formulas.h"
#include "rig/rolling_parts.h"
#include "theory/hertz.h"

namespace tricontact::rig {

namespace {

using contact::HalfSpaceScales;
using contact::RollingRig;
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

std::string beside(double ratio) {
    return fmt::format("{:.1f} % {}", 100 * std::abs(ratio - 1),
                       ratio < 1 ? "below Hertz" : "above Hertz");
}

std::string print_sentence(const RollingRig& rig) {
    if (!rig.measured_contact_size) return "";
    const double hertz = 2 * half_size(rig), layer = hertz * ratio(quantities[0], rig);
    const auto [size, error] = *rig.measured_contact_size;
    const bool fits_hertz = std::abs(size - hertz) <= error;
    const bool fits_layer = std::abs(size - layer) <= error;
    const char* verdict = fits_hertz && fits_layer ? "cannot tell the two apart"
                          : fits_layer             ? "fits the layer, not Hertz"
                          : fits_hertz             ? "fits Hertz, not the layer"
                                                   : "fits neither";
    return fmt::format(
        " The measured diameter of {:.2f} ± {:.2f} mm {}: {:.2f} mm on the layer, {:.2f} mm by "
        "Hertz.",
        1e3 * size, 1e3 * error, verdict, 1e3 * layer, 1e3 * hertz);
}

}  // namespace

Assumption half_space(const RollingRig& rig) {
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = "The substrate is a half-space, since b >= D_c suffices",
                 .criteria = {{thickness_ratio(rig), Criterion::Relation::at_least, 1,
                               "the thesis' own rule (section 5.1.5)"}},
                 .background = {},
                 .missing = {},
                 .consequence = {}};
    for (const Quantity& q : quantities) {
        a.criteria.push_back({difference(q, rig), Criterion::Relation::at_most, accepted_difference,
                              accepted_reason});
        a.background.push_back(on_half_space(q, rig));
        a.background.push_back(on_layer(q, rig));
    }
    a.background.push_back(modulus_factor(rig, true));
    a.background.push_back(modulus_factor(rig, false));
    a.consequence = fmt::format(
        "Indentation is {}: E from force and indentation would be {:.2f} times the true one. "
        "The stiffness is {:.2f} times Hertz', the peak pressure {}, the unit of shift {}. "
        "The contact radius is {}.{}",
        beside(ratio(quantities[1], rig)), modulus_factor(rig, true).result.value,
        ratio(quantities[4], rig), beside(ratio(quantities[2], rig)),
        beside(ratio(quantities[3], rig)), beside(ratio(quantities[0], rig)), print_sentence(rig));
    return a;
}

}  // namespace tricontact::rig
