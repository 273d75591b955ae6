// What drags the specimen: spring, rod, sensor, and how its force is sampled.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/assumptions/walking_parts.h"

namespace tricontact::experiments {

namespace {

using enum Criterion::Relation;
using std::numbers::pi;

constexpr double least_kappa1 = 0.1, largest_kappa1 = 10;
constexpr double least_series_ratio = 0.95;
constexpr double largest_beam_ratio = 0.01;

constexpr Formula kappa1("kappa1", "kappa_1", "k_s/k_x", "(5.2.19)", "1", "k_s k_x",
                         [](const Values& x) { return x[0] / x[1]; });

constexpr Formula series_ratio("series_ratio", "k_s/k", "1/(1 + k/k_sensor)", "(5.2.16)", "1",
                               "k k_sensor", [](const Values& x) { return 1 / (1 + x[0] / x[1]); });

// Of a round rod: its radius from k = E_s pi r_s^2/l_s, of values that begin with k, l_s, E_s.
double rod_radius_of(const Values& x) {
    return std::sqrt(x[0] * x[1] / (pi * x[2]));
}
double slender(const Values& x) {
    return 0.75 * std::pow(rod_radius_of(x) / x[1], 2);
}
double over_width(const Values& x) {
    return 0.25 * std::pow(rod_radius_of(x) / x[3], 2);
}

constexpr Formula bending_force_ratio("bending_force_ratio", "F_bZ/F_cZ",
                                      "3 E_s I_s/(l_s^3 k_z) = 3/4 (r_s/l_s)^2 k/k_z", "(5.2.41)",
                                      "1", "k l_s E_s k_z",
                                      [](const Values& x) { return slender(x) * x[0] / x[3]; });
constexpr Formula bending_moment_ratio("bending_moment_ratio", "M_b/M_c",
                                       "E_s I_s/(l_s k_z b^2) = 1/4 (r_s/b)^2 k/k_z", "(5.2.41)",
                                       "1", "k l_s E_s b k_z",
                                       [](const Values& x) { return over_width(x) * x[0] / x[4]; });
constexpr Formula rod_radius("rod_radius", "r_s", "sqrt(k l_s/(pi E_s))", "(5.2.12)", "m",
                             "k l_s E_s", rod_radius_of);
constexpr Formula beam_force_ratio("beam_force_ratio", "F_bZ/F_cZ, k_z = k", "3/4 (r_s/l_s)^2",
                                   "(5.2.42)", "1", "k l_s E_s", slender);
constexpr Formula beam_moment_ratio("beam_moment_ratio", "M_b/M_c, k_z = k", "1/4 (r_s/b)^2",
                                    "(5.2.42)", "1", "k l_s E_s b", over_width);

constexpr Formula tilting_ratio("tilting_ratio", "mu/mu_c", "mu kappa_3 (1 + kappa_8)", "(4.3.3)",
                                "1", "mu a b kappa_8",
                                [](const Values& x) { return x[0] * x[1] / x[2] * (1 + x[3]); });

constexpr Formula sampling_ratio("sampling_ratio", "f_samp/(2 Omega_exp)",
                                 "f_samp/(2 Omega_exp), Omega_exp in cycles per second", "(5.2.1)",
                                 "1", "f_samp Omega_exp",
                                 [](const Values& x) { return x[0] / (2 * x[1]); });
constexpr Formula nyquist_rate("nyquist_rate", "2 Omega_exp/(2 pi)", "2 Omega_exp/(2 pi)",
                               "(5.2.1)", "Hz", "Omega_exp",
                               [](const Values& x) { return 2 * x[0] / (2 * pi); });

}  // namespace

Assumption similar_stiffness(const Rig& rig) {
    const Calculation kappa = calculate(rig, kappa1);
    const char* reason = "micro-walking was found for kappa_1 about 1 (5.2.8): within a decade";
    return {.name = "similar_stiffness",
            .title = "Spring and contact",
            .claim = "Spring and contact are of similar stiffness",
            .criteria = {{kappa, at_least, least_kappa1, reason},
                         {kappa, at_most, largest_kappa1, reason}},
            .background = {spring_stiffness(rig)},
            .consequence = fmt::format(
                "kappa_1 is {}.", kappa.result.standard_error > 0
                                      ? with_error(kappa.result.value, kappa.result.standard_error)
                                      : significant(kappa.result.value, 3))};
}

Assumption rigid_sensor(const Rig& rig) {
    Assumption a{"rigid_sensor", "Force sensor", "The force sensor is rigid beside the spring"};
    if (!decide(a, rig, series_ratio, at_least, least_series_ratio,
                "5 % of the spring's stiffness"))
        return a;
    a.consequence = fmt::format("With the sensor in series the spring is {} % softer than alone.",
                                significant(100 * (1 - a.deciding_value()), 2));
    return a;
}

Assumption rod_as_spring(const Rig& rig) {
    Assumption a{"rod_as_spring", "Rod as a spring",
                 "The rod pulls only: its bending is negligible"};
    if (!rig.has("l_s") || !rig.has("E_s")) {
        a.missing = {"rig.rod_length and rig.rod_young of a rod"};
        return a;
    }
    a.criteria = {{calculate(rig, bending_force_ratio), at_most, largest_beam_ratio,
                   "1 % of the contact's force"},
                  {calculate(rig, bending_moment_ratio), at_most, largest_beam_ratio,
                   "1 % of the contact's moment"}};
    a.background = known(rig, {&rod_radius, &beam_force_ratio, &beam_moment_ratio});
    a.consequence = fmt::format("Bending adds {} % to the contact's force and {} % to its moment.",
                                significant(100 * a.deciding_value(), 2),
                                significant(100 * a.criteria[1].calculation.result.value, 2));
    return a;
}

Assumption no_tilting(const Rig& rig) {
    Assumption a{"no_tilting", "No tilting", "Friction alone does not tilt the specimen"};
    if (!decide(a, rig, tilting_ratio, at_most, 1, "at mu_c one contact lifts off")) return a;
    a.consequence = fmt::format("The critical coefficient is {}.",
                                significant(rig["mu"].value / a.deciding_value(), 3));
    return a;
}

Assumption sampled_often(const Rig& rig) {
    Assumption a{"sampled_often", "Sampling", "The force is sampled often enough"};
    if (!decide(a, rig, sampling_ratio, at_least, 1, "Nyquist and Shannon")) return a;
    a.background = known(rig, {&nyquist_rate});
    a.consequence = fmt::format("The force is sampled at {} times the least rate.",
                                significant(a.deciding_value(), 3));
    return a;
}

}  // namespace tricontact::experiments
