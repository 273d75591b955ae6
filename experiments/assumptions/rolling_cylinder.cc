// The normal contact of a cylinder: half-space or layer, and its ends.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "experiments/assumptions/rolling_parts.h"
#include "theory/sharp_edge.h"

namespace tricontact::experiments {

namespace {

using contact::quantity;
using contact::Sentence;
using contact::significant;

using Values = std::vector<double>;

// Hertz' values of with_length(hertz_given), the layer's of with_length(layer_given).
double hertz_width(const Values& x) {
    return 2 * line_half_width_of(x);
}
double line_pressure(const Values& x) {
    return 2 * x[1] / (std::numbers::pi * line_half_width_of(x) * x[6]);
}
double thesis_indentation(const Values& x) {
    return 2 * x[1] / (std::numbers::pi * materials_of(x).effective_modulus() * x[6]) *
           ((1 + std::log(4.)) / 2 + std::log(x[6] / line_half_width_of(x)));
}
double layer_width(const Values& x) {
    return 2 * layer_line_of(x).half_width;
}
double layer_pressure(const Values& x) {
    return layer_line_of(x).centre_pressure;
}
double layer_indentation(const Values& x) {
    return layer_line_of(x).indentation;
}

constexpr ComparedQuantity line_quantities[] = {
    {"contact_width", "2a", "2 sqrt(4 R F_N/(pi E* L))", "(3.5.2)", "m", hertz_width, layer_width},
    {"peak_pressure", "p_0", "2 F_N/(pi a L)", "(3.5.2)", "Pa", line_pressure, layer_pressure},
    {"indentation", "d", "2 F_N/(pi E* L) [(1 + ln 4)/2 + ln(L/a)]", "(3.5.3)", "m",
     thesis_indentation, layer_indentation}};

Calculation line_thickness_ratio(const RollingRig& rig) {
    return calculate("thickness_ratio", "b/D_c", "b/(2 a)", "(5.1.13)", "1",
                     {{"b", rig.substrate.thickness, "m"}, {"a", {half_size(rig)}, "m"}},
                     [](const auto& x) { return x[0] / (2 * x[1]); });
}

Calculation length_ratio(const RollingRig& rig) {
    return calculate("length_ratio", "L/a", "L/a", "section 5.1.5", "1",
                     {{"L", *rig.roller.length, "m"}, {"a", {half_size(rig)}, "m"}},
                     [](const auto& x) { return x[0] / x[1]; });
}

Calculation end_pressure(const RollingRig& rig) {
    return calculate("end_pressure_ratio", "p_0'/p_0",
                     "1 - nu_2^2, ends of roller and substrate flush", "(5.1.14)", "1",
                     {{"nu_2", rig.substrate.poisson, "1"}},
                     [](const auto& x) { return 1 - x[0] * x[0]; });
}

Calculation edge_exponent(const RollingRig& rig) {
    return calculate("edge_exponent", "lambda - 1",
                     "p ~ y^(lambda - 1) at an edge of 90 degrees, lambda of Dundurs' alpha",
                     "Dundurs and Lee (1972)", "1",
                     {{"E_1", rig.roller.young, "Pa"},
                      {"nu_1", rig.roller.poisson, "1"},
                      {"E_2", rig.substrate.young, "Pa"},
                      {"nu_2", rig.substrate.poisson, "1"}},
                     [](const auto& x) {
                         const double roller = x[0] / (1 - x[1] * x[1]);
                         const double substrate = x[2] / (1 - x[3] * x[3]);
                         return theory::edge_pressure_exponent(
                             std::numbers::pi / 2, (roller - substrate) / (roller + substrate));
                     });
}

Calculation moved_load(const RollingRig& rig) {
    return calculate("end_load_share", "dF/F_N",
                     "nu_2^2 2 (2 a)/L: a contact width at each end loses nu_2^2 p", "(5.1.14)",
                     "1",
                     {{"nu_2", rig.substrate.poisson, "1"},
                      {"a", {half_size(rig)}, "m"},
                      {"L", *rig.roller.length, "m"}},
                     [](const auto& x) { return x[0] * x[0] * 4 * x[1] / x[2]; });
}

/// Both contacts of a line, in the order of the quantities that are compared.
struct LineSubject {
    const RollingRig& rig;
    bool rigid = roller_is_rigid(rig);
    std::vector<double> half_space = values_of(with_length(hertz_given(rig), rig));
    std::vector<double> layer = values_of(with_length(layer_given(rig), rig));
};

std::string line_sentence(const LineSubject& s) {
    return fmt::format(
        "The contact width is {}, the peak pressure {}. The indentation is {}; a half-space has "
        "none of its own in plane strain, the formula of a block of length L on it says {}.",
        beside_hertz(layer_width(s.layer) / hertz_width(s.half_space)),
        beside_hertz(layer_pressure(s.layer) / line_pressure(s.half_space)),
        quantity(layer_indentation(s.layer), "m", 3),
        quantity(thesis_indentation(s.half_space), "m", 3));
}

constexpr Sentence<LineSubject> line_sentences[] = {
    {[](const LineSubject& s) { return s.rigid; }, line_sentence},
    {[](const LineSubject& s) { return !s.rigid; },
     [](const LineSubject& /*s*/) {
         return std::string(
             "The roller is not rigid beside the substrate, as the layer's theory takes it: the "
             "two contacts are not compared.");
     }}};

/// What the ends of a cylinder do to its pressure.
struct EndsSubject {
    const RollingRig& rig;
    double lost = 1 - end_pressure(rig).result.value;
    double moved = moved_load(rig).result.value;
    double exponent = edge_exponent(rig).result.value;
    double length_ratio = experiments::length_ratio(rig).result.value;
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
    return fmt::format(
        "Flush ends lose {} of the pressure{}", percent_text(s.lost, 2),
        ends_are_apart(s)
            ? fmt::format(" over about a contact width each, which moves {} of the load inwards.",
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
             "The exponent -0.23 of section 5.1.5 belongs to two equal materials. The rig is "
             "between flush and reaching past; its ends are not measured.");
     }}};

}  // namespace

Assumption half_space_of_line(const RollingRig& rig) {
    return half_space_assumption(
        rig, line_thickness_ratio(rig), line_quantities,
        {"singular integral equation", "exact plane contact with a bonded layer"},
        told(line_sentences, LineSubject{rig}));
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

}  // namespace tricontact::experiments
