// The quantities of a rig, and its contact spots: their diameter and stiffness.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

using Walking = const Rig&;

// Four contacts under planes at 45 degrees carry m g together.
double spot_force(double mass) {
    return mass * gravity / (2 * std::numbers::sqrt2);
}

constexpr double largest_factor = 2;
constexpr double largest_relative_error = 0.2;
constexpr const char* factor_reason = "estimates within a factor of two";

double hertz_diameter_of(const Values& x) {
    return std::cbrt(6 * x[4] * x[5] / pair_of(x).effective_modulus());
}

double quotient(const Values& x) {
    return x[0] / x[1];
}

constexpr Formula hertz_diameter("hertz_diameter", "D_c, Hertz",
                                 "(6 F_N R_c/E*)^(1/3), F_N = m g/(2 sqrt(2))", "(5.2.4)", "m",
                                 "E_1 nu_1 E_2 nu_2 F_N R_c", hertz_diameter_of);

constexpr Formula hertz_ratio("hertz_diameter_ratio", "D_c Hertz/D_c", "(6 F_N R_c/E*)^(1/3)/D_c",
                              "(5.2.4)", "1", "E_1 nu_1 E_2 nu_2 F_N R_c D_c",
                              [](const Values& x) { return hertz_diameter_of(x) / x[6]; });

constexpr Formula wear_ratio("wear_diameter_ratio", "D_c wear/D_c",
                             "2 sqrt(a b) of the wear spots over D_c", "(5.2.5)", "1", "D_wear D_c",
                             quotient);

constexpr Formula diameter_of_frequency("contact_diameter", "D_c, frequency",
                                        "k_x/G*, k_x = m/tau^2", "(5.2.6), (5.2.7)", "m",
                                        "E_1 nu_1 E_2 nu_2 m tau", [](const Values& x) {
                                            return x[4] / (x[5] * x[5]) /
                                                   pair_of(x).effective_shear_modulus();
                                        });

constexpr Formula stiffness_of_time("contact_stiffness", "k_x", "m/tau^2", "(5.2.30)", "N/m",
                                    "m tau", [](const Values& x) { return x[0] / (x[1] * x[1]); });

constexpr Formula stiffness_of_means("contact_stiffness_of_means", "k_x, means",
                                     "m (Omega_exp/omega_sim)^2", "(5.2.38)", "N/m",
                                     "m Omega_exp omega_sim", [](const Values& x) {
                                         return x[0] * std::pow(x[1] / x[2], 2);
                                     });

constexpr Formula characteristic_time("characteristic_time", "tau, means", "omega_sim/Omega_exp",
                                      "(5.2.35)", "s", "omega_sim Omega_exp", quotient);

constexpr Formula stiffness_ratio("kappa2", "kappa_2", "k_z/k_x = E*/G*", "(5.2.29)", "1",
                                  material_keys, [](const Values& x) {
                                      return pair_of(x).effective_modulus() /
                                             pair_of(x).effective_shear_modulus();
                                  });

constexpr Formula slenderness("kappa3", "kappa_3", "a/b", "tables 4.3.1, 4.3.2", "1", "a b",
                              quotient);

constexpr Formula weight_ratio("kappa4", "kappa_4", "m g/(k_x b)", "(5.2.8)", "1", "m k_x b",
                               [](const Values& x) { return x[0] * gravity / (x[1] * x[2]); });

Calculation relative_error(const Calculation& stiffness) {
    const auto& k = stiffness.result;
    return calculate("stiffness_error", "s(k_x)/k_x", "propagated through " + stiffness.formula,
                     "(A.1.4)", "1",
                     {{"k_x", {k.value}, "N/m"}, {"s(k_x)", {k.standard_error}, "N/m"}},
                     [](const auto& x) { return x[1] / x[0]; });
}

std::string claim_of_diameter(const Rig& rig) {
    const int ways = 1 + rig.has("D_wear") + rig.has("tau");
    if (ways == 1) return "Hertz' formula finds the contact diameter of the evaluation";
    return fmt::format("{} ways find the same contact diameter", ways == 2 ? "Two" : "Three");
}

/// `hertz`: D_c of Hertz [m]; `ratio`: over that of the evaluation.
std::string edge_sentences(const Rig& rig, double hertz, double ratio) {
    std::string text = fmt::format(
        "A round edge of {} pressed for the first time has a contact of {} diameter, {} times as "
        "stiff as one of D_c = {}.",
        quantity(rig["R_c"].value, "m", 3), quantity(hertz, "m", 2), significant(ratio, 2),
        quantity(rig["D_c"].value, "m", 2));
    if (ratio < 1 / largest_factor)
        text += " The evaluation rests on contacts that are not fresh edges, as by wear.";
    return text;
}

}  // namespace

const std::vector<DerivedQuantity>& walking_quantities() {
    static const std::vector<DerivedQuantity> table{
        {"F_N", "N",
         [](Walking r) -> std::optional<Estimate> {
             return Estimate{spot_force(r["m"].value), spot_force(r["m"].standard_error)};
         }},
        {"k_x", "N/m", [](Walking r) { return result_if_known(r, tangential_stiffness); }},
        {"k_z", "N/m", [](Walking r) { return result_if_known(r, normal_stiffness); }},
        {"b", "m", [](Walking r) { return result_if_known(r, half_width); }},
        {"a", "m", [](Walking r) { return result_if_known(r, half_height); }},
        {"k_s", "N/m",
         [](Walking r) -> std::optional<Estimate> { return spring_stiffness(r).result; }}};
    return table;
}

contact::MaterialPair pair_of(const Values& x) {
    return {contact::Material{x[0], x[1]}, contact::Material{x[2], x[3]}};
}

constinit const Formula tangential_stiffness("tangential_stiffness", "k_x",
                                             "G* D_c, 1/G* = sum (2 - nu_i)/(4 G_i)", "(5.2.3)",
                                             "N/m", "E_1 nu_1 E_2 nu_2 D_c", [](const Values& x) {
                                                 return pair_of(x).effective_shear_modulus() * x[4];
                                             });

constinit const Formula normal_stiffness("normal_stiffness", "k_z",
                                         "E* D_c, 1/E* = sum (1 - nu_i)/(2 G_i)", "(5.2.3)", "N/m",
                                         "E_1 nu_1 E_2 nu_2 D_c", [](const Values& x) {
                                             return pair_of(x).effective_modulus() * x[4];
                                         });

constinit const Formula half_width("half_width", "b", "l_1/2 + l_2", "table 5.2.1", "m", "l_1 l_2",
                                   [](const Values& x) { return x[0] / 2 + x[1]; });

constinit const Formula half_height("half_height", "a", "D/(2 sqrt(2))", "table 5.2.1", "m", "D",
                                    [](const Values& x) {
                                        return x[0] / (2 * std::numbers::sqrt2);
                                    });

Calculation spring_stiffness(const Rig& rig) {
    constexpr Formula alone("spring_stiffness", "k_s", "k, the sensor taken as rigid", "(5.2.16)",
                            "N/m", "k", [](const Values& x) { return x[0]; });
    constexpr Formula in_series("spring_stiffness", "k_s", "1/(1/k + 1/k_sensor)", "(5.2.16)",
                                "N/m", "k k_sensor",
                                [](const Values& x) { return 1 / (1 / x[0] + 1 / x[1]); });
    return calculate(rig, rig.has("k_sensor") ? in_series : alone);
}

Assumption contact_diameter(const Rig& rig) {
    using enum Criterion::Relation;
    Assumption a{
        .name = "contact_diameter",
        .title = "Contact diameter",
        .claim = claim_of_diameter(rig),
        .criteria = {{calculate(rig, hertz_ratio), at_least, 1 / largest_factor, factor_reason}},
        .background = known(
            rig, {&hertz_diameter, &normal_stiffness, &tangential_stiffness, &stiffness_ratio,
                  &half_height, &half_width, &slenderness, &weight_ratio, &diameter_of_frequency})};
    a.consequence =
        edge_sentences(rig, calculate(rig, hertz_diameter).result.value, a.deciding_value());
    if (rig.has("D_wear"))
        a.criteria.push_back({calculate(rig, wear_ratio), at_most, largest_factor, factor_reason});
    return a;
}

Assumption known_stiffness(const Rig& rig) {
    const bool oscillates = rig.has("tau");
    const Calculation stiffness =
        calculate(rig, oscillates ? stiffness_of_time : tangential_stiffness);
    Assumption a{
        .name = "known_stiffness",
        .title = "Contact stiffness",
        .claim = "The contact stiffness is known well enough to determine kappa_1 and kappa_4",
        .criteria = {{relative_error(stiffness), Criterion::Relation::at_most,
                      largest_relative_error, "kappa_1, kappa_4 and kappa_6 inherit it"}},
        .background = known(rig, {&characteristic_time, &stiffness_of_time, &stiffness_of_means})};
    const double error = a.deciding_value();
    if (!(error > 0))
        a.missing = {oscillates ? "standard errors of machine.mass and rig.characteristic_time"
                                : "standard errors of contact.diameter and of the materials"};
    else
        a.consequence =
            fmt::format("The contact stiffness is uncertain by {} %.", significant(100 * error, 2));
    if (oscillates && rig["tau"].standard_error > 0)
        a.consequence +=
            fmt::format(" It goes with 1/tau^2, so that the {} % of tau count twice.",
                        significant(100 * rig["tau"].standard_error / rig["tau"].value, 2));
    return a;
}

}  // namespace tricontact::experiments
