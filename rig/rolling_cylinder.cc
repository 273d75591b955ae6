// The normal contact of a cylinder: half-space or layer, and its ends.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "rig/rolling_formulas.h"
#include "rig/rolling_parts.h"
#include "theory/sharp_edge.h"

namespace tricontact::rig {

namespace {

using contact::RollingRig;

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

Calculation on_half_space(const RollingRig& rig, const char* name, const char* symbol,
                          const char* formula, const char* source, const char* unit,
                          double (*function)(const std::vector<double>&)) {
    return calculate({.name = name,
                      .symbol = symbol,
                      .formula = formula,
                      .source = source,
                      .unit = unit,
                      .given = with_length(hertz_given(rig), rig),
                      .function = function,
                      .result = {}});
}

Calculation on_layer(const RollingRig& rig, const char* name, const char* symbol, const char* unit,
                     double (*value)(const theory::LineContact&)) {
    return calculate({.name = name,
                      .symbol = symbol,
                      .formula = "singular integral equation",
                      .source = layer_source,
                      .unit = unit,
                      .given = with_length(layer_given(rig), rig),
                      .function = [value](const auto& x) { return value(layer_line_of(x)); },
                      .result = {}});
}

Criterion difference(const RollingRig& rig, const char* name, const char* symbol,
                     double (*half_space)(const std::vector<double>&),
                     double (*layer)(const theory::LineContact&)) {
    return {calculate({.name = name,
                       .symbol = fmt::format("|{0} layer/{0} Hertz - 1|", symbol),
                       .formula = "the layer's over the half-space's, from the same data",
                       .source = layer_source,
                       .unit = "1",
                       .given = with(with_length(hertz_given(rig), rig),
                                     {"b", rig.substrate.thickness, "m"}),
                       .function =
                           [half_space, layer](const auto& x) {
                               return std::abs(layer(layer_line_beside(x)) / half_space(x) - 1);
                           },
                       .result = {}}),
            Criterion::Relation::at_most, accepted_difference, accepted_reason};
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

}  // namespace

Assumption half_space_of_line(const RollingRig& rig) {
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = "The substrate is a half-space, since b >= D_c suffices",
                 .criteria = {{thickness_ratio(rig), Criterion::Relation::at_least, 1,
                               "the thesis' own rule (section 5.1.5)"}},
                 .background = {},
                 .missing = {},
                 .consequence = {}};
    for (const Criterion& one :
         {difference(rig, "contact_width_difference", "2a", hertz_width, width),
          difference(rig, "peak_pressure_difference", "p_0", line_pressure, pressure),
          difference(rig, "indentation_difference", "d", thesis_indentation, indentation)})
        a.criteria.push_back(one);
    a.background.push_back(on_half_space(rig, "contact_width", "2a", "2 sqrt(4 R F_N/(pi E* L))",
                                         "(3.5.2)", "m", hertz_width));
    a.background.push_back(on_layer(rig, "layer_contact_width", "2a, layer", "m", width));
    a.background.push_back(on_half_space(rig, "peak_pressure", "p_0", "2 F_N/(pi a L)", "(3.5.2)",
                                         "Pa", line_pressure));
    a.background.push_back(on_layer(rig, "layer_peak_pressure", "p_0, layer", "Pa", pressure));
    a.background.push_back(on_half_space(rig, "indentation", "d",
                                         "2 F_N/(pi E* L) [(1 + ln 4)/2 + ln(L/a)]", "(3.5.3)", "m",
                                         thesis_indentation));
    a.background.push_back(on_layer(rig, "layer_indentation", "d, layer", "m", indentation));
    const auto value = [&](std::size_t i) { return a.background[i].result.value; };
    a.consequence = fmt::format(
        "The contact width is {:.1f} % below Hertz, the peak pressure {:.1f} % above; the "
        "indentation, {:.3f} mm, is {:.1f} times smaller than that of a block of length L on the "
        "half-space, which has no indentation of its own in plane strain.",
        100 * (1 - value(1) / value(0)), 100 * (value(3) / value(2) - 1), 1e3 * value(5),
        value(4) / value(5));
    return a;
}

Assumption long_cylinder(const RollingRig& rig) {
    Assumption a{.name = "long_cylinder",
                 .title = "Long cylinder",
                 .claim = "Pressure does not vary along the cylinder",
                 .criteria = {{moved_load(rig), Criterion::Relation::at_most, accepted_difference,
                               accepted_reason}},
                 .background = {length_ratio(rig), end_pressure(rig), edge_exponent(rig)},
                 .missing = {"how far the substrate reaches past the ends"},
                 .consequence = {}};
    a.consequence = fmt::format(
        "Flush ends lose {:.0f} % of the pressure over about a contact width each, which moves "
        "{:.1f} % of the load inwards. A substrate that reaches past a sharp end has a pressure "
        "growing as y^{:.2f} there: steel is rigid beside rubber (-0.23 belongs to two equal "
        "materials); rounded ends raise it within about their radius. The rig is between the two "
        "and its ends are not measured.",
        100 * (1 - a.background[1].result.value), 100 * a.criteria.front().calculation.result.value,
        a.background[2].result.value);
    return a;
}

}  // namespace tricontact::rig
