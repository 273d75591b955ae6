// The quantities of a rig, and its contact spots: their diameter and stiffness.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

constexpr double largest_factor = 2;
constexpr double largest_relative_error = 0.2;
constexpr const char* factor_reason = "estimates within a factor of two";

constexpr Inputs discs{&Rig::E_1, &Rig::nu_1, &Rig::E_2, &Rig::nu_2};

contact::MaterialPair pair_of(const RigData& r) {
    return {contact::Material{r.E_1, r.nu_1}, contact::Material{r.E_2, r.nu_2}};
}

double hertz_diameter_of(const RigData& r) {
    return std::cbrt(6 * r.F_N * r.R_c / pair_of(r).effective_modulus());
}

constexpr Inputs hertz_diameter_inputs = discs + Inputs{&Rig::F_N, &Rig::R_c};
constexpr Formula hertz_diameter("hertz_diameter", "D_c, Hertz",
                                 "(6 F_N R_c/E*)^(1/3), F_N = m g/(2 sqrt(2))", "(5.2.4)", "m",
                                 hertz_diameter_inputs, hertz_diameter_of);

constexpr Formula hertz_ratio("hertz_diameter_ratio", "D_c Hertz/D_c", "(6 F_N R_c/E*)^(1/3)/D_c",
                              "(5.2.4)", "1", hertz_diameter_inputs + Inputs{&Rig::D_c},
                              [](const RigData& r) { return hertz_diameter_of(r) / r.D_c; });

constexpr Formula wear_ratio("wear_diameter_ratio", "D_c wear/D_c",
                             "2 sqrt(a b) of the wear spots over D_c", "(5.2.5)", "1",
                             {&Rig::D_wear, &Rig::D_c},
                             [](const RigData& r) { return r.D_wear / r.D_c; });

constexpr Formula diameter_of_frequency("contact_diameter", "D_c, frequency",
                                        "k_x/G*, k_x = m/tau^2", "(5.2.6), (5.2.7)", "m",
                                        discs + Inputs{&Rig::m, &Rig::tau}, [](const RigData& r) {
                                            return r.m / (r.tau * r.tau) /
                                                   pair_of(r).effective_shear_modulus();
                                        });

constexpr Formula stiffness_of_time("contact_stiffness", "k_x", "m/tau^2", "(5.2.30)", "N/m",
                                    {&Rig::m, &Rig::tau},
                                    [](const RigData& r) { return r.m / (r.tau * r.tau); });

constexpr Formula stiffness_of_means("contact_stiffness_of_means", "k_x, means",
                                     "m (Omega_exp/omega_sim)^2", "(5.2.38)", "N/m",
                                     {&Rig::m, &Rig::Omega_exp, &Rig::omega_sim},
                                     [](const RigData& r) {
                                         return r.m * std::pow(r.Omega_exp / r.omega_sim, 2);
                                     });

constexpr Formula characteristic_time("characteristic_time", "tau, means", "omega_sim/Omega_exp",
                                      "(5.2.35)", "s", {&Rig::omega_sim, &Rig::Omega_exp},
                                      [](const RigData& r) { return r.omega_sim / r.Omega_exp; });

constexpr Formula stiffness_ratio("kappa2", "kappa_2", "k_z/k_x = E*/G*", "(5.2.29)", "1", discs,
                                  [](const RigData& r) {
                                      return pair_of(r).effective_modulus() /
                                             pair_of(r).effective_shear_modulus();
                                  });

constexpr Formula slenderness("kappa3", "kappa_3", "a/b", "tables 4.3.1, 4.3.2", "1",
                              {&Rig::a, &Rig::b}, [](const RigData& r) { return r.a / r.b; });

constexpr Formula weight_ratio("kappa4", "kappa_4", "m g/(k_x b)", "(5.2.8)", "1",
                               {&Rig::m, &Rig::k_x, &Rig::b},
                               [](const RigData& r) { return r.m * gravity / (r.k_x * r.b); });

Calculation relative_error(const Calculation& stiffness) {
    const auto& k = stiffness.result;
    return calculate("stiffness_error", "s(k_x)/k_x", "propagated through " + stiffness.formula,
                     "(A.1.4)", "1",
                     {{"k_x", {k.value}, "N/m"}, {"s(k_x)", {k.standard_error}, "N/m"}},
                     [](const auto& x) { return x.back() / x.front(); });
}

std::string claim_of_diameter(const Rig& rig) {
    const int ways = 1 + rig.D_wear.is_known() + rig.tau.is_known();
    if (ways == 1) return "Hertz' formula finds the contact diameter of the evaluation";
    return fmt::format("{} ways find the same contact diameter", ways == 2 ? "Two" : "Three");
}

/// `hertz`: D_c of Hertz [m]; `ratio`: over that of the evaluation.
std::string edge_sentences(const Rig& rig, double hertz, double ratio) {
    std::string text = fmt::format(
        "A round edge of {} pressed for the first time has a contact of {} diameter, {} times as "
        "stiff as one of D_c = {}.",
        quantity(rig.R_c, "m", 3), quantity(hertz, "m", 2), significant(ratio, 2),
        quantity(rig.D_c, "m", 2));
    if (ratio < 1 / largest_factor)
        text += " The evaluation rests on contacts that are not fresh edges, as by wear.";
    return text;
}

}  // namespace

RigNumber spot_force(const Rig& rig) {
    const auto share = [](double mass) { return mass * gravity / (2 * std::numbers::sqrt2); };
    return {share(rig.m), share(rig.m.standard_error)};
}

constinit const Formula tangential_stiffness(
    "tangential_stiffness", "k_x", "G* D_c, 1/G* = sum (2 - nu_i)/(4 G_i)", "(5.2.3)", "N/m",
    discs + Inputs{&Rig::D_c},
    [](const RigData& r) { return pair_of(r).effective_shear_modulus() * r.D_c; });

constinit const Formula normal_stiffness("normal_stiffness", "k_z",
                                         "E* D_c, 1/E* = sum (1 - nu_i)/(2 G_i)", "(5.2.3)", "N/m",
                                         discs + Inputs{&Rig::D_c}, [](const RigData& r) {
                                             return pair_of(r).effective_modulus() * r.D_c;
                                         });

constinit const Formula half_width("half_width", "b", "l_1/2 + l_2", "table 5.2.1", "m",
                                   {&Rig::l_1, &Rig::l_2},
                                   [](const RigData& r) { return r.l_1 / 2 + r.l_2; });

constinit const Formula half_height("half_height", "a", "D/(2 sqrt(2))", "table 5.2.1", "m",
                                    {&Rig::D}, [](const RigData& r) {
                                        return r.D / (2 * std::numbers::sqrt2);
                                    });

Calculation spring_stiffness(const Rig& rig) {
    constexpr Formula alone("spring_stiffness", "k_s", "k, the sensor taken as rigid", "(5.2.16)",
                            "N/m", {&Rig::k}, [](const RigData& r) { return r.k.value; });
    constexpr Formula in_series("spring_stiffness", "k_s", "1/(1/k + 1/k_sensor)", "(5.2.16)",
                                "N/m", {&Rig::k, &Rig::k_sensor},
                                [](const RigData& r) { return 1 / (1 / r.k + 1 / r.k_sensor); });
    return calculate(rig, rig.k_sensor.is_known() ? in_series : alone);
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
    if (rig.D_wear.is_known())
        a.criteria.push_back({calculate(rig, wear_ratio), at_most, largest_factor, factor_reason});
    return a;
}

Assumption known_stiffness(const Rig& rig) {
    const bool oscillates = rig.tau.is_known();
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
    if (oscillates && rig.tau.standard_error > 0)
        a.consequence += fmt::format(" It goes with 1/tau^2, so that the {} % of tau count twice.",
                                     significant(100 * rig.tau.standard_error / rig.tau, 2));
    return a;
}

}  // namespace tricontact::experiments
