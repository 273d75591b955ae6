// What the drive does: slowly enough, and rolling only.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

// Inertia changes an amplitude by (f_0/f_1)^2: 1 % at 10.
constexpr double least_frequency_ratio = 10;
constexpr double least_wave_ratio = 100;
constexpr double largest_wobble = 0.01;

constexpr Formula wobble_ratio("wobble_ratio", "DU R/(mu a^2)", "DU R/(mu a^2)", "(3.1.5)", "1",
                               {&Rig::DU, &Rig::R, &Rig::mu, &Rig::a_reference},
                               [](const RigData& r) {
                                   return r.DU * r.R / (r.mu * r.a_reference * r.a_reference);
                               });
// The speed that belongs to the printed frequency.
constexpr Formula drive_speed("drive_speed", "v", "4 W f_0, f_0 as printed", "section 5.1.5", "m/s",
                              {&Rig::W, &Rig::f_0_printed},
                              [](const RigData& r) { return 4 * r.W * r.f_0_printed; });
constexpr Formula frequency_ratio("frequency_ratio", "f_1/f_0", "f_1/f_0", "section 5.1.5", "1",
                                  {&Rig::f_1, &Rig::f_0},
                                  [](const RigData& r) { return r.f_1 / r.f_0; });
constexpr Formula wave_ratio("wave_ratio", "T_c c_s/D_c",
                             "sqrt(G_2/rho)/(f_0 D_c), G_2 = E_2/(2 (1 + nu_2)), D_c = 2 a",
                             "(2.3.1)", "1", {&Rig::E_2, &Rig::nu_2, &Rig::rho, &Rig::f_0, &Rig::a},
                             [](const RigData& r) {
                                 return std::sqrt(r.E_2 / (2 * (1 + r.nu_2)) / r.rho) /
                                        (r.f_0 * 2 * r.a);
                             });
constexpr Formula pivot_height_error("pivot_height_error", "Dh", "DU R/W", "(5.1.11)", "m",
                                     {&Rig::DU, &Rig::R, &Rig::W_pivot},
                                     [](const RigData& r) { return r.DU * r.R / r.W_pivot; });
// What the printed height error would do.
constexpr Formula pivot_displacement("pivot_displacement", "DU", "Dh W/R, Dh as printed",
                                     "(5.1.11)", "m", {&Rig::Dh_printed, &Rig::R, &Rig::W_pivot},
                                     [](const RigData& r) {
                                         return r.Dh_printed * r.W_pivot / r.R;
                                     });

// Of f_1/f_0.
std::string inertia_sentence(double ratio) {
    if (ratio > 1)  // x/(1 - x), x = (f_0/f_1)^2: an undamped oscillator driven at its base
        return fmt::format(
            "Without damping inertia of the rig changes the motion by {}: the fastest oscillation "
            "is {} times slower than the lowest eigenfrequency.",
            percent_text(1 / (ratio * ratio - 1), 2), significant(ratio, 3));
    return fmt::format(
        "The fastest oscillation is {} times as fast as the lowest eigenfrequency: inertia of the "
        "rig decides its motion.",
        significant(1 / ratio, 3));
}

}  // namespace

constinit const Formula smallest_amplitude("smallest_amplitude", "W", "w a", "(3.1.4)", "m",
                                           {&Rig::w, &Rig::a_reference},
                                           [](const RigData& r) { return r.w * r.a_reference; });
constinit const Formula pivot_amplitude("pivot_amplitude", "W", "w a", "(3.1.4)", "m",
                                        {&Rig::w_pivot, &Rig::a_reference},
                                        [](const RigData& r) { return r.w_pivot * r.a_reference; });
constinit const Formula excitation_frequency("excitation_frequency", "f_0", "v/(4 W)",
                                             "section 5.1.5", "Hz", {&Rig::v, &Rig::W},
                                             [](const RigData& r) { return r.v / (4 * r.W); });

Assumption quasi_static_drive(const Rig& rig) {
    using enum Criterion::Relation;
    Assumption a{
        .name = "quasi_static_drive",
        .title = "Quasi-static drive",
        .claim = "The drive is quasi-static: inertia of the rig and elastic waves are negligible",
        .background = known(rig, {&smallest_amplitude, &excitation_frequency, &drive_speed})};
    if (decide(a, rig, frequency_ratio, at_least, least_frequency_ratio,
               "inertia changes the motion by (f_0/f_1)^2: 1 % at 10"))
        a.consequence = inertia_sentence(a.deciding_value());
    decide(a, rig, wave_ratio, at_least, least_wave_ratio,
           "shear waves cross the contact a hundred times within a period");
    return a;
}

Assumption ideal_rolling(const Rig& rig) {
    Assumption a{
        "ideal_rolling", "Ideal rolling",
        "The lever's pivot is level with the contact: rolling alone does not move the substrate"};
    if (!decide(a, rig, wobble_ratio, Criterion::Relation::at_most, largest_wobble,
                "measured shifts are of the order mu a^2/R"))
        return a;
    a.background = known(rig, {&pivot_amplitude, &pivot_height_error, &pivot_displacement});
    a.consequence = fmt::format(
        "Shifts wobble by {} of mu a^2/R within a period; read with the roller upright they are "
        "not touched.",
        percent_text(a.deciding_value(), 2));
    return a;
}

}  // namespace tricontact::experiments
