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

constexpr Formula kappa1("kappa1", "kappa_1", "k_s/k_x", "(5.2.19)", "1", {&Rig::k_s, &Rig::k_x},
                         [](const RigData& r) { return r.k_s / r.k_x; });

constexpr Formula series_ratio("series_ratio", "k_s/k", "1/(1 + k/k_sensor)", "(5.2.16)", "1",
                               {&Rig::k, &Rig::k_sensor},
                               [](const RigData& r) { return 1 / (1 + r.k / r.k_sensor); });

// Of a round rod: its radius from k = E_s pi r_s^2/l_s.
constexpr Inputs rod{&Rig::k, &Rig::l_s, &Rig::E_s};
double rod_radius_of(const RigData& r) {
    return std::sqrt(r.k * r.l_s / (pi * r.E_s));
}
double slender(const RigData& r) {
    return 0.75 * std::pow(rod_radius_of(r) / r.l_s, 2);
}
double over_width(const RigData& r) {
    return 0.25 * std::pow(rod_radius_of(r) / r.b, 2);
}

constexpr Formula bending_force_ratio("bending_force_ratio", "F_bZ/F_cZ",
                                      "3 E_s I_s/(l_s^3 k_z) = 3/4 (r_s/l_s)^2 k/k_z", "(5.2.41)",
                                      "1", rod + Inputs{&Rig::k_z},
                                      [](const RigData& r) { return slender(r) * r.k / r.k_z; });
constexpr Formula bending_moment_ratio("bending_moment_ratio", "M_b/M_c",
                                       "E_s I_s/(l_s k_z b^2) = 1/4 (r_s/b)^2 k/k_z", "(5.2.41)",
                                       "1", rod + Inputs{&Rig::b, &Rig::k_z}, [](const RigData& r) {
                                           return over_width(r) * r.k / r.k_z;
                                       });
constexpr Formula rod_radius("rod_radius", "r_s", "sqrt(k l_s/(pi E_s))", "(5.2.12)", "m", rod,
                             rod_radius_of);
constexpr Formula beam_force_ratio("beam_force_ratio", "F_bZ/F_cZ, k_z = k", "3/4 (r_s/l_s)^2",
                                   "(5.2.42)", "1", rod, slender);
constexpr Formula beam_moment_ratio("beam_moment_ratio", "M_b/M_c, k_z = k", "1/4 (r_s/b)^2",
                                    "(5.2.42)", "1", rod + Inputs{&Rig::b}, over_width);

constexpr Formula tilting_ratio("tilting_ratio", "mu/mu_c", "mu kappa_3 (1 + kappa_8)", "(4.3.3)",
                                "1", {&Rig::mu, &Rig::a, &Rig::b, &Rig::kappa_8},
                                [](const RigData& r) {
                                    return r.mu * r.a / r.b * (1 + r.kappa_8);
                                });

constexpr Formula sampling_ratio("sampling_ratio", "f_samp/(2 Omega_exp)",
                                 "f_samp/(2 Omega_exp), Omega_exp in cycles per second", "(5.2.1)",
                                 "1", {&Rig::f_samp, &Rig::Omega_exp},
                                 [](const RigData& r) { return r.f_samp / (2 * r.Omega_exp); });
constexpr Formula nyquist_rate("nyquist_rate", "2 Omega_exp/(2 pi)", "2 Omega_exp/(2 pi)",
                               "(5.2.1)", "Hz", {&Rig::Omega_exp},
                               [](const RigData& r) { return 2 * r.Omega_exp / (2 * pi); });

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
    if (!rig.l_s.is_known() || !rig.E_s.is_known()) {
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
    a.consequence =
        fmt::format("The critical coefficient is {}.", significant(rig.mu / a.deciding_value(), 3));
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
