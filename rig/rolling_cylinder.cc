// The normal contact of a cylinder: half-space or layer, and its ends.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "rig/rolling_formulas.h"
#include "rig/rolling_parts.h"
#include "rig/thesis_rigs.h"
#include "theory/sharp_edge.h"

namespace tricontact::rig {

namespace {

using contact::quantity;
using contact::RollingRig;
using contact::Sentence;
using contact::significant;

constexpr const char* layer_source = "exact plane contact with a bonded layer";

// Hertz' values of with_length(hertz_given), and the layer's from the same with b behind.
double line_pressure(const std::vector<double>& x) {
    return 2 * x[1] / (std::numbers::pi * line_half_width_of(x) * x[6]);
}
theory::LineContact layer_line_beside(const std::vector<double>& x) {
    return layer_line_of({x[0], x[1], x[7], x[4], x[5], x[6]});
}
double thesis_indentation(const std::vector<double>& x) {
    return 2 * x[1] / (std::numbers::pi * materials_of(x).effective_modulus() * x[6]) *
           ((1 + std::log(4.)) / 2 + std::log(x[6] / line_half_width_of(x)));
}

double width(const theory::LineContact& line) {
    return 2 * line.half_width;
}
double pressure(const theory::LineContact& line) {
    return line.centre_pressure;
}
double indentation(const theory::LineContact& line) {
    return line.indentation;
}
double hertz_width(const std::vector<double>& x) {
    return 2 * line_half_width_of(x);
}

/// One quantity of the line contact, by both theories.
struct LineQuantity {
    const char *name, *symbol, *formula, *source, *unit;
    double (*half_space)(const std::vector<double>&);
    double (*layer)(const theory::LineContact&);
};

constexpr LineQuantity line_quantities[] = {
    {"contact_width", "2a", "2 sqrt(4 R F_N/(pi E* L))", "(3.5.2)", "m", hertz_width, width},
    {"peak_pressure", "p_0", "2 F_N/(pi a L)", "(3.5.2)", "Pa", line_pressure, pressure},
    {"indentation", "d", "2 F_N/(pi E* L) [(1 + ln 4)/2 + ln(L/a)]", "(3.5.3)", "m",
     thesis_indentation, indentation}};

Calculation on_half_space(const RollingRig& rig, const LineQuantity& q) {
    return calculate({.name = q.name,
                      .symbol = q.symbol,
                      .formula = q.formula,
                      .source = q.source,
                      .unit = q.unit,
                      .given = with_length(hertz_given(rig), rig),
                      .function = q.half_space,
                      .result = {}});
}

Calculation on_layer(const RollingRig& rig, const LineQuantity& q) {
    return calculate({.name = std::string("layer_") + q.name,
                      .symbol = std::string(q.symbol) + ", layer",
                      .formula = "singular integral equation",
                      .source = layer_source,
                      .unit = q.unit,
                      .given = with_length(layer_given(rig), rig),
                      .function = [&q](const auto& x) { return q.layer(layer_line_of(x)); },
                      .result = {}});
}

Criterion difference(const RollingRig& rig, const LineQuantity& q) {
    return {calculate({.name = std::string(q.name) + "_difference",
                       .symbol = fmt::format("|{0} layer/{0} Hertz - 1|", q.symbol),
                       .formula = "the layer's over the half-space's, from the same data",
                       .source = layer_source,
                       .unit = "1",
                       .given = with(with_length(hertz_given(rig), rig),
                                     {"b", rig.substrate.thickness, "m"}),
                       .function =
                           [&q](const auto& x) {
                               return std::abs(q.layer(layer_line_beside(x)) / q.half_space(x) - 1);
                           },
                       .result = {}}),
            Criterion::Relation::at_most, accepted_difference, accepted_reason};
}

Calculation thickness_ratio(const RollingRig& rig) {
    return calculate({.name = "thickness_ratio",
                      .symbol = "b/D_c",
                      .formula = "b/(2 a)",
                      .source = "(5.1.13)",
                      .unit = "1",
                      .given = {{"b", rig.substrate.thickness, "m"}, {"a", {half_size(rig)}, "m"}},
                      .function = [](const auto& x) { return x[0] / (2 * x[1]); },
                      .result = {}});
}

Calculation length_ratio(const RollingRig& rig) {
    return calculate({.name = "length_ratio",
                      .symbol = "L/a",
                      .formula = "L/a",
                      .source = "section 5.1.5",
                      .unit = "1",
                      .given = {{"L", *rig.roller.length, "m"}, {"a", {half_size(rig)}, "m"}},
                      .function = [](const auto& x) { return x[0] / x[1]; },
                      .result = {}});
}

Calculation end_pressure(const RollingRig& rig) {
    return calculate({.name = "end_pressure_ratio",
                      .symbol = "p_0'/p_0",
                      .formula = "1 - nu_2^2, ends of roller and substrate flush",
                      .source = "(5.1.14)",
                      .unit = "1",
                      .given = {{"nu_2", rig.substrate.poisson, "1"}},
                      .function = [](const auto& x) { return 1 - x[0] * x[0]; },
                      .result = {}});
}

Calculation edge_exponent(const RollingRig& rig) {
    return calculate({.name = "edge_exponent",
                      .symbol = "lambda - 1",
                      .formula = "p ~ y^(lambda - 1) at an edge of 90 degrees, lambda of Dundurs' "
                                 "alpha",
                      .source = "Dundurs and Lee (1972)",
                      .unit = "1",
                      .given = {{"E_1", rig.roller.young, "Pa"},
                                {"nu_1", rig.roller.poisson, "1"},
                                {"E_2", rig.substrate.young, "Pa"},
                                {"nu_2", rig.substrate.poisson, "1"}},
                      .function =
                          [](const auto& x) {
                              const double roller = x[0] / (1 - x[1] * x[1]);
                              const double substrate = x[2] / (1 - x[3] * x[3]);
                              return theory::edge_pressure_exponent(
                                  std::numbers::pi / 2,
                                  (roller - substrate) / (roller + substrate));
                          },
                      .result = {}});
}

Calculation moved_load(const RollingRig& rig) {
    return calculate({.name = "end_load_share",
                      .symbol = "dF/F_N",
                      .formula = "nu_2^2 2 (2 a)/L: a contact width at each end loses nu_2^2 p",
                      .source = "(5.1.14)",
                      .unit = "1",
                      .given = {{"nu_2", rig.substrate.poisson, "1"},
                                {"a", {half_size(rig)}, "m"},
                                {"L", *rig.roller.length, "m"}},
                      .function = [](const auto& x) { return x[0] * x[0] * 4 * x[1] / x[2]; },
                      .result = {}});
}

/// Both contacts of a line, in the order of the quantities that are compared.
struct LineSubject {
    const RollingRig& rig;
    bool rigid = roller_is_rigid(rig);
    std::vector<double> half_space = values_of(with_length(hertz_given(rig), rig));
    std::vector<double> layer = values_of(with_length(layer_given(rig), rig));
};

std::string line_sentence(const LineSubject& s) {
    const theory::LineContact line = layer_line_of(s.layer);
    return fmt::format(
        "The contact width is {}, the peak pressure {}. The indentation is {}; a half-space has "
        "none of its own in plane strain, the formula of a block of length L on it says {}.",
        beside_hertz(width(line) / hertz_width(s.half_space)),
        beside_hertz(pressure(line) / line_pressure(s.half_space)),
        quantity(indentation(line), "m", 3), quantity(thesis_indentation(s.half_space), "m", 3));
}

constexpr Sentence<LineSubject> line_sentences[] = {
    {[](const LineSubject& s) { return s.rigid; }, line_sentence},
    {[](const LineSubject& s) { return !s.rigid; },
     [](const LineSubject& /*s*/) {
         return std::string(
             "The roller is not rigid beside the substrate, as the layer's theory "
             "takes it: the two contacts are not compared.");
     }}};

/// What the ends of a cylinder do to its pressure.
struct EndsSubject {
    const RollingRig& rig;
    double lost = 1 - end_pressure(rig).result.value;
    double moved = moved_load(rig).result.value;
    double exponent = edge_exponent(rig).result.value;
    double length_ratio = tricontact::rig::length_ratio(rig).result.value;
};

// A contact width at each end needs two; a cylinder shorter than four of them is all ends.
constexpr double least_length_ratio = 8;
// The edge of a body a thousand times stiffer: the exponent is -1/2 within so much.
constexpr double rigid_edge = 2e-3;

bool ends_lose(const EndsSubject& s) {
    return s.lost > 0;
}
bool ends_are_apart(const EndsSubject& s) {
    return ends_lose(s) && s.length_ratio >= least_length_ratio;
}
bool edge_is_singular(const EndsSubject& s) {
    return s.exponent < -rigid_edge;
}

std::string loss_sentence(const EndsSubject& s) {
    return fmt::format("Flush ends lose {} of the pressure{}", percent_text(s.lost, 2),
                       ends_are_apart(s)
                           ? fmt::format(" over about a contact width each, which moves {} of the "
                                         "load inwards.",
                                         percent_text(s.moved, 2))
                           : "; the cylinder is too short for them to be apart.");
}

std::string edge_sentence(const EndsSubject& s) {
    return fmt::format(
        "A substrate that reaches past a sharp end has a pressure growing as y^{} there{}; rounded "
        "ends raise it within about their radius.",
        significant(s.exponent, 2),
        s.exponent < rigid_edge - 0.5 ? ", as under the edge of a rigid body" : "");
}

constexpr Sentence<EndsSubject> ends_sentences[] = {
    {ends_lose, loss_sentence},
    {[](const EndsSubject& s) { return !ends_lose(s); },
     [](const EndsSubject& /*s*/) {
         return std::string("Flush ends keep the pressure, as nu_2 = 0.");
     }},
    {edge_is_singular, edge_sentence},
    {[](const EndsSubject& s) { return is_thesis_rig(s.rig); },
     [](const EndsSubject& /*s*/) {
         return std::string(
             "The exponent -0.23 of section 5.1.5 belongs to two equal materials. "
             "The rig is between flush and reaching past; its ends are not "
             "measured.");
     }}};

}  // namespace

Assumption half_space_of_line(const RollingRig& rig) {
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = half_space_claim(rig),
                 .criteria = {thick_enough(thickness_ratio(rig))},
                 .background = {},
                 .missing = {},
                 .consequence = told(line_sentences, LineSubject{rig})};
    const bool compared = roller_is_rigid(rig);
    if (!compared) a.missing = {theory_of_elastic_roller};
    for (const LineQuantity& q : line_quantities) {
        a.background.push_back(on_half_space(rig, q));
        if (!compared) continue;
        a.criteria.push_back(difference(rig, q));
        a.background.push_back(on_layer(rig, q));
    }
    return a;
}

Assumption long_cylinder(const RollingRig& rig) {
    return {.name = "long_cylinder",
            .title = "Long cylinder",
            .claim = "Pressure does not vary along the cylinder",
            .criteria = {{moved_load(rig), Criterion::Relation::at_most, accepted_difference,
                          accepted_reason}},
            .background = {length_ratio(rig), end_pressure(rig), edge_exponent(rig)},
            .missing = {"how far the substrate reaches past the ends"},
            .consequence = told(ends_sentences, EndsSubject{rig})};
}

}  // namespace tricontact::rig
