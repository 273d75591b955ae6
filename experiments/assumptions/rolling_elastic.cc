// The substrate's material: elastic at the speed of the drive.
#include <fmt/format.h>

#include <numbers>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using contact::quantity;
using contact::Sentence;
using contact::significant;

constexpr double largest_loss = 0.01;

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
    return calculate(name, symbol, formula, source, unit, viscous_given(rig), function);
}

Calculation shear_modulus(const RollingRig& rig) {
    return calculate("shear_modulus", "G_1", "E_2/(2 (1 + nu_2))", "section 5.1.5", "Pa",
                     {{"E_2", rig.substrate.young, "Pa"}, {"nu_2", rig.substrate.poisson, "1"}},
                     [](const auto& x) { return shear_modulus_of(x[0], x[1]); });
}

// omega tau, tau = eta/G_2, of values in the order of viscous_given with G_2/G_1 behind.
double period_ratio_of(const std::vector<double>& x) {
    return viscous_ratio_of(x) / x[6];
}

Calculation with_maxwell_ratio(const RollingRig& rig, const char* name, const char* symbol,
                               const char* formula, const char* source,
                               double (*function)(const std::vector<double>&)) {
    return calculate(name, symbol, formula, source, "1",
                     with(viscous_given(rig), {"G_2/G_1", *rig.substrate.maxwell_ratio, "1"}),
                     function);
}

Calculation loss_modulus(const RollingRig& rig) {
    return with_maxwell_ratio(rig, "loss_modulus", "G''/(omega eta)",
                              "1/(1 + (omega tau)^2), tau = eta/G_2", "standard solid",
                              [](const std::vector<double>& x) {
                                  const double t = period_ratio_of(x);
                                  return 1 / (1 + t * t);
                              });
}

Calculation loss_modulus_as_printed(const RollingRig& rig) {
    return with_maxwell_ratio(
        rig, "loss_modulus_as_printed", "G''/(omega eta), print",
        "omega tau/(1 + (omega tau)^2), from G'' = G_2 (omega tau)^2/(1 + (omega tau)^2)",
        "(5.1.16)", [](const std::vector<double>& x) {
            const double t = period_ratio_of(x);
            return t / (1 + t * t);
        });
}

Calculation viscous_ratio(const RollingRig& rig) {
    return viscous(rig, "viscous_ratio", "omega eta/G_1",
                   "2 pi v/(4 w a) eta/G_1, G_1 = E_2/(2 (1 + nu_2))", "(5.1.17)", "1",
                   viscous_ratio_of);
}

Calculation elastic_speed(const RollingRig& rig) {
    return viscous(
        rig, "elastic_speed", "v_max", "0.01 v/(omega eta/G_1)", "(5.1.17)", "m/s",
        [](const std::vector<double>& x) { return largest_loss * x[0] / viscous_ratio_of(x); });
}

bool is_thesis_rig_with_maxwell_ratio(const RollingRig& rig) {
    return is_thesis_rig(rig) && rig.substrate.maxwell_ratio;
}

constexpr Sentence<RollingRig> elastic_sentences[] = {
    // G'' = omega eta/(1 + (omega tau)^2) <= omega eta, whatever G_2 is.
    {contact::always,
     [](const RollingRig& rig) {
         return fmt::format(
             "Viscous stresses are at most {} of the elastic ones; up to a drive speed of {} they "
             "stay below {}.",
             percent_text(viscous_ratio(rig).result.value, 2),
             quantity(elastic_speed(rig).result.value, "m/s", 3), percent_text(largest_loss, 1));
     }},
    {is_thesis_rig_with_maxwell_ratio, [](const RollingRig& rig) {
         return fmt::format(
             "The loss modulus as printed in (5.1.16) has a square too many: a slow dash-pot gives "
             "G'' = omega eta, the print {} of that (with G_2 = {} G_1).",
             percent_text(loss_modulus_as_printed(rig).result.value, 2),
             significant(rig.substrate.maxwell_ratio->value, 2));
     }}};

}  // namespace

Assumption elastic_substrate(const RollingRig& rig) {
    Assumption a{.name = "elastic_substrate",
                 .title = "Elastic substrate",
                 .claim = "The substrate is elastic at the speed of the drive",
                 .background = {shear_modulus(rig)}};
    if (!rig.substrate.viscosity) {
        a.missing = {"substrate.viscosity"};
        return a;
    }
    a.criteria.push_back({viscous_ratio(rig), Criterion::Relation::at_most, largest_loss,
                          "bounds the loss angle of the standard solid"});
    a.background.push_back(elastic_speed(rig));
    if (rig.substrate.maxwell_ratio) a.background.push_back(loss_modulus(rig));
    if (is_thesis_rig_with_maxwell_ratio(rig)) a.background.push_back(loss_modulus_as_printed(rig));
    a.consequence = told(elastic_sentences, rig);
    return a;
}

}  // namespace tricontact::experiments
