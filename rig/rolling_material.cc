// The substrate's material: elastic, uncoupled, and what was fitted.
#include <fmt/format.h>

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "rig/rolling_formulas.h"
#include "rig/rolling_parts.h"
#include "theory/layer_compliance.h"

namespace tricontact::rig {

namespace {

using contact::RollingRig;

constexpr double largest_loss = 0.01;
constexpr double largest_beta = 0.01;
// G_2/G_1 of the example for the loss modulus; rubbers have more than this.
constexpr double maxwell_ratio = 10;

std::vector<Given> viscous_given(const RollingRig& rig) {
    return {{"v", rig.drive.speed, "m/s"},      {"w", rig.drive.smallest_amplitude_ratio, "1"},
            {"a", reference_radius(rig), "m"},  {"eta", *rig.substrate.viscosity, "Pa s"},
            {"E_2", rig.substrate.young, "Pa"}, {"nu_2", rig.substrate.poisson, "1"}};
}

double shear_modulus_of(double young, double poisson) {
    return young / (2 * (1 + poisson));
}

// omega eta/G_1 of values in the order of viscous_given.
double viscous_ratio_of(const std::vector<double>& x) {
    return 2 * std::numbers::pi * x[0] / (4 * x[1] * x[2]) * x[3] / shear_modulus_of(x[4], x[5]);
}

Calculation viscous(const RollingRig& rig, const char* name, const char* symbol,
                    const char* formula, const char* source, const char* unit,
                    double (*function)(const std::vector<double>&)) {
    return calculate({.name = name,
                      .symbol = symbol,
                      .formula = formula,
                      .source = source,
                      .unit = unit,
                      .given = viscous_given(rig),
                      .function = function,
                      .result = {}});
}

Calculation shear_modulus(const RollingRig& rig) {
    return calculate(
        {.name = "shear_modulus",
         .symbol = "G_1",
         .formula = "E_2/(2 (1 + nu_2))",
         .source = "section 5.1.5",
         .unit = "Pa",
         .given = {{"E_2", rig.substrate.young, "Pa"}, {"nu_2", rig.substrate.poisson, "1"}},
         .function = [](const auto& x) { return shear_modulus_of(x[0], x[1]); },
         .result = {}});
}

Calculation dundurs_beta(const RollingRig& rig) {
    return calculate(
        {.name = "dundurs_beta",
         .symbol = "|beta|",
         .formula = "1/2 |(1 - 2 nu_2)/G_2 - (1 - 2 nu_1)/G_1|/[(1 - nu_1)/G_1 + "
                    "(1 - nu_2)/G_2]",
         .source = "(2.1.1)",
         .unit = "1",
         .given = hertz_given(rig),
         .function = [](const auto& x) { return std::abs(materials_of(x).dundurs_beta()); },
         .result = {}});
}

Calculation layer_coupling(const RollingRig& rig) {
    return calculate({.name = "layer_coupling",
                      .symbol = "|C_13|/sqrt(C_11 C_33)",
                      .formula = "surface compliances of the bonded layer at the wave number 1/a",
                      .source = "docs/models/bem-layer.md",
                      .unit = "1",
                      .given = {{"b", rig.substrate.thickness, "m"},
                                {"a", {half_size(rig)}, "m"},
                                {"E_2", rig.substrate.young, "Pa"},
                                {"nu_2", rig.substrate.poisson, "1"}},
                      .function =
                          [](const auto& x) {
                              const auto c = theory::layer_compliance(
                                  {{x[2], x[3]}, x[0], theory::LayerBase::bonded}, 1 / x[1]);
                              return std::abs(c.coupling) / std::sqrt(c.along * c.normal);
                          },
                      .result = {}});
}

Calculation coupling_effect(double coupled, double uncoupled) {
    return calculate(
        {.name = "coupling_effect",
         .symbol = "|U_stat coupled/U_stat uncoupled - 1|",
         .formula = fmt::format("shift at F_T = {} mu F_N, pressed with friction",
                                coupling_tangential_ratio),
         .source = "boundary elements on the layer",
         .unit = "1",
         .given = {{"U_stat coupled", {coupled}, "m"}, {"U_stat uncoupled", {uncoupled}, "m"}},
         .function = [](const auto& x) { return std::abs(x[0] / x[1] - 1); },
         .result = {}});
}

// U_max/mu of the layer for values in the order of layer_given.
double layer_shift_of(std::vector<double> x, double young) {
    x[3] = young;
    return *layer_of(x).unit_shift;
}

// The modulus for which the layer has the half-space's U_max; values of hertz_given and b behind.
double layer_modulus_of(const std::vector<double>& x) {
    const double wanted = hertz_of(x).unit_shift;
    const auto excess = [&](double log_factor) {
        return std::log(layer_shift_of({x[0], x[1], x[6], 0, x[5]}, x[4] * std::exp(log_factor)) /
                        wanted);
    };
    std::uintmax_t evaluations = 100;
    // A layer is stiffer than its half-space, by less than the thickness effect of 20.
    const auto [left, right] = boost::math::tools::toms748_solve(
        excess, -3., 0.5, boost::math::tools::eps_tolerance<double>(40), evaluations);
    return x[4] * std::exp(std::midpoint(left, right));
}

Calculation layer_modulus(const RollingRig& rig, bool as_factor) {
    return calculate({.name = as_factor ? "fitted_modulus_error" : "layer_modulus",
                      .symbol = as_factor ? "E_2/E_2,layer - 1" : "E_2,layer",
                      .formula = "E_2,layer: the layer's U_max equals mu d E*/G* of E_2",
                      .source = "(3.1.5), exact contact with a bonded layer",
                      .unit = as_factor ? "1" : "Pa",
                      .given = with(hertz_given(rig), {"b", rig.substrate.thickness, "m"}),
                      .function =
                          [as_factor](const auto& x) {
                              const double young = layer_modulus_of(x);
                              return as_factor ? x[4] / young - 1 : young;
                          },
                      .result = {}});
}

}  // namespace

Assumption elastic_substrate(const RollingRig& rig) {
    Assumption a{.name = "elastic_substrate",
                 .title = "Elastic rubber",
                 .claim = "The rubber is elastic at the speed of the drive",
                 .criteria = {},
                 .background = {shear_modulus(rig)},
                 .missing = {},
                 .consequence = {}};
    if (!rig.substrate.viscosity) {
        a.missing = {"substrate.viscosity"};
        return a;
    }
    a.criteria.push_back({viscous(rig, "viscous_ratio", "omega eta/G_1",
                                  "2 pi v/(4 w a) eta/G_1, G_1 = E_2/(2 (1 + nu_2))", "(5.1.17)",
                                  "1", viscous_ratio_of),
                          Criterion::Relation::at_most, largest_loss,
                          "the loss angle of the standard solid at low frequencies"});
    a.background.push_back(viscous(
        rig, "elastic_speed", "v_max", "0.01 v/(omega eta/G_1)", "(5.1.17)", "m/s",
        [](const std::vector<double>& x) { return largest_loss * x[0] / viscous_ratio_of(x); }));
    a.background.push_back(viscous(rig, "loss_modulus", "G''/(omega eta)",
                                   "1/(1 + (omega tau)^2), tau = eta/G_2, G_2 = 10 G_1",
                                   "standard solid", "1", [](const std::vector<double>& x) {
                                       const double t = viscous_ratio_of(x) / maxwell_ratio;
                                       return 1 / (1 + t * t);
                                   }));
    a.background.push_back(
        viscous(rig, "loss_modulus_as_printed", "G''/(omega eta), print",
                "omega tau/(1 + (omega tau)^2), from G'' = G_2 (omega tau)^2/(1 + (omega tau)^2)",
                "(5.1.16)", "1", [](const std::vector<double>& x) {
                    const double t = viscous_ratio_of(x) / maxwell_ratio;
                    return t / (1 + t * t);
                }));
    a.consequence = fmt::format(
        "Viscous stresses are one part in {:.0f} of the elastic ones; they reach 1 % at a drive "
        "speed of {:.0f} mm/s. The loss modulus as printed in (5.1.16) has a square too many: a "
        "slow dash-pot gives G'' = omega eta, the print one part in {:.0f} of that.",
        1 / a.criteria.front().calculation.result.value, 1e3 * a.background[1].result.value,
        1 / a.background[3].result.value);
    return a;
}

Assumption uncoupled(const RollingRig& rig, const StaticShift& static_shift) {
    using enum Criterion::Relation;
    Assumption a{.name = "uncoupled",
                 .title = "Normal and tangential contact uncoupled",
                 .claim = "Normal and tangential contact do not couple",
                 .criteria = {{dundurs_beta(rig), at_most, largest_beta,
                               "changes of shift are of the order beta"}},
                 .background = {layer_coupling(rig)},
                 .missing = {},
                 .consequence = {}};
    a.consequence = fmt::format(
        "Two half-spaces of these materials would not couple. The bonded layer does, at {:.0f} % "
        "of the geometric mean of its compliances at the wave number 1/a",
        100 * a.background.front().result.value);
    if (!static_shift) {
        a.missing = {"the effect of the layer's coupling on the shift"};
        a.consequence += '.';
        return a;
    }
    a.criteria.push_back({coupling_effect(static_shift(rig, true), static_shift(rig, false)),
                          at_most, accepted_difference, accepted_reason});
    a.consequence += fmt::format(", but that changes the static shift by {:.2f} % only.",
                                 100 * a.criteria.back().calculation.result.value);
    return a;
}

Assumption fitted_constants(const RollingRig& rig) {
    Assumption a{.name = "fitted_constants",
                 .title = "Fitted constants",
                 .claim = "E_2, fitted to static shifts by the half-space, is the rubber's",
                 .criteria = {{layer_modulus(rig, true), Criterion::Relation::at_most,
                               accepted_difference, accepted_reason}},
                 .background = {layer_modulus(rig, false)},
                 .missing = {},
                 .consequence = {}};
    a.consequence = fmt::format(
        "The half-space finds {:.2f} MPa where the layer has {:.2f} MPa: {:.0f} % too high. mu is "
        "not touched as far as the shift's curve keeps its shape over F_T/(mu F_N).",
        1e-6 * rig.substrate.young.value, 1e-6 * a.background.front().result.value,
        100 * a.criteria.front().calculation.result.value);
    return a;
}

}  // namespace tricontact::rig
