// The substrate's material: elastic at the speed of the drive.
#include <fmt/format.h>

#include <numbers>

#include "contact/number_text.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using contact::quantity;
using contact::significant;

constexpr double largest_loss = 0.01;

constexpr const char* viscous_keys = "v w a' eta E_2 nu_2";
constexpr const char* maxwell_keys = "v w a' eta E_2 nu_2 G_2/G_1";

double shear_modulus_of(double young, double poisson) {
    return young / (2 * (1 + poisson));
}

// omega eta/G_1 of values in the order of viscous_keys.
double viscous_ratio_of(const Values& x) {
    return 2 * std::numbers::pi * x[0] / (4 * x[1] * x[2]) * x[3] / shear_modulus_of(x[4], x[5]);
}

// omega tau, tau = eta/G_2, of values in the order of maxwell_keys.
double period_ratio_of(const Values& x) {
    return viscous_ratio_of(x) / x[6];
}

constexpr Formula shear_modulus("shear_modulus", "G_1", "E_2/(2 (1 + nu_2))", "section 5.1.5", "Pa",
                                "E_2 nu_2",
                                [](const Values& x) { return shear_modulus_of(x[0], x[1]); });

constexpr Formula viscous_ratio("viscous_ratio", "omega eta/G_1",
                                "2 pi v/(4 w a) eta/G_1, G_1 = E_2/(2 (1 + nu_2))", "(5.1.17)", "1",
                                viscous_keys, viscous_ratio_of);

constexpr Formula elastic_speed("elastic_speed", "v_max", "0.01 v/(omega eta/G_1)", "(5.1.17)",
                                "m/s", viscous_keys, [](const Values& x) {
                                    return largest_loss * x[0] / viscous_ratio_of(x);
                                });

constexpr Formula loss_modulus("loss_modulus", "G''/(omega eta)",
                               "1/(1 + (omega tau)^2), tau = eta/G_2", "standard solid", "1",
                               maxwell_keys, [](const Values& x) {
                                   const double t = period_ratio_of(x);
                                   return 1 / (1 + t * t);
                               });

constexpr Formula loss_modulus_as_printed(
    "loss_modulus_as_printed", "G''/(omega eta), print",
    "omega tau/(1 + (omega tau)^2), from G'' = G_2 (omega tau)^2/(1 + (omega tau)^2)", "(5.1.16)",
    "1", maxwell_keys, [](const Values& x) {
        const double t = period_ratio_of(x);
        return t / (1 + t * t);
    });

}  // namespace

Assumption elastic_substrate(const Rig& rig) {
    Assumption a{.name = "elastic_substrate",
                 .title = "Elastic substrate",
                 .claim = "The substrate is elastic at the speed of the drive",
                 .background = known(rig, {&shear_modulus, &elastic_speed, &loss_modulus})};
    if (!decide(a, rig, viscous_ratio, Criterion::Relation::at_most, largest_loss,
                "bounds the loss angle of the standard solid"))
        return a;
    // G'' = omega eta/(1 + (omega tau)^2) <= omega eta, whatever G_2 is.
    a.consequence = fmt::format(
        "Viscous stresses are at most {} of the elastic ones; up to a drive speed of {} they stay "
        "below {}.",
        percent_text(a.deciding_value(), 2),
        quantity(calculate(rig, elastic_speed).result.value, "m/s", 3),
        percent_text(largest_loss, 1));
    if (is_thesis_rig(rig) && rig.has("G_2/G_1")) {
        const Calculation& print =
            a.background.emplace_back(calculate(rig, loss_modulus_as_printed));
        a.consequence += fmt::format(
            " The loss modulus as printed in (5.1.16) has a square too many: a slow dash-pot gives "
            "G'' = omega eta, the print {} of that (with G_2 = {} G_1).",
            percent_text(print.result.value, 2), significant(rig["G_2/G_1"].value, 2));
    }
    return a;
}

}  // namespace tricontact::experiments
