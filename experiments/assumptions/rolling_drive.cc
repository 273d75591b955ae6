// What the drive does: slowly enough, and rolling only.
#include <fmt/format.h>

#include <cmath>

#include "contact/number_text.h"
#include "contact/sentence.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using contact::Sentence;
using contact::significant;

// Inertia changes an amplitude by (f_0/f_1)^2: 1 % at 10.
constexpr double least_frequency_ratio = 10;
constexpr double least_wave_ratio = 100;
constexpr double largest_wobble = 0.01;

// W = w a of a ratio.
Calculation amplitude(const RollingRig& rig, const char* name, const statistics::Uncertain& ratio) {
    return calculate(name, "W", "w a", "(3.1.4)", "m",
                     {{"w", ratio, "1"}, {"a", reference_radius(rig), "m"}},
                     [](const auto& x) { return x[0] * x[1]; });
}

Calculation smallest_amplitude(const RollingRig& rig) {
    return amplitude(rig, "smallest_amplitude", rig.drive.smallest_amplitude_ratio);
}

Calculation pivot_amplitude(const RollingRig& rig) {
    return amplitude(rig, "pivot_amplitude", rig.pivot->amplitude_ratio);
}

Calculation excitation_frequency(const RollingRig& rig) {
    return calculate("excitation_frequency", "f_0", "v/(4 W)", "section 5.1.5", "Hz",
                     {{"v", rig.drive.speed, "m/s"}, {"W", smallest_amplitude(rig).result, "m"}},
                     [](const auto& x) { return x[0] / (4 * x[1]); });
}

// The speed that belongs to the printed frequency.
Calculation drive_speed(const RollingRig& rig, const PrintedValue& frequency) {
    return calculate("drive_speed", "v", "4 W f_0, f_0 as printed", "section 5.1.5", "m/s",
                     {{"W", smallest_amplitude(rig).result, "m"}, {"f_0", frequency.value, "Hz"}},
                     [](const auto& x) { return 4 * x[0] * x[1]; });
}

Calculation frequency_ratio(const RollingRig& rig, const statistics::Uncertain& f0) {
    return calculate("frequency_ratio", "f_1/f_0", "f_1/f_0", "section 5.1.5", "1",
                     {{"f_1", *rig.drive.eigenfrequency, "Hz"}, {"f_0", f0, "Hz"}},
                     [](const auto& x) { return x[0] / x[1]; });
}

Calculation wave_ratio(const RollingRig& rig, const statistics::Uncertain& f0) {
    return calculate("wave_ratio", "T_c c_s/D_c",
                     "sqrt(G_2/rho)/(f_0 D_c), G_2 = E_2/(2 (1 + nu_2)), D_c = 2 a", "(2.3.1)", "1",
                     {{"E_2", rig.substrate.young, "Pa"},
                      {"nu_2", rig.substrate.poisson, "1"},
                      {"rho", *rig.substrate.density, "kg/m3"},
                      {"f_0", f0, "Hz"},
                      {"a", {half_size(rig)}, "m"}},
                     [](const auto& x) {
                         return std::sqrt(x[0] / (2 * (1 + x[1])) / x[2]) / (x[3] * 2 * x[4]);
                     });
}

Calculation pivot_height_error(const RollingRig& rig) {
    return calculate("pivot_height_error", "Dh", "DU R/W", "(5.1.11)", "m",
                     {{"DU", rig.pivot->displacement, "m"},
                      {"R", rig.roller.radius, "m"},
                      {"W", pivot_amplitude(rig).result, "m"}},
                     [](const auto& x) { return x[0] * x[1] / x[2]; });
}

// What the printed height error would do.
Calculation pivot_displacement(const RollingRig& rig, const PrintedValue& height) {
    return calculate("pivot_displacement", "DU", "Dh W/R, Dh as printed", "(5.1.11)", "m",
                     {{"Dh", height.value, "m"},
                      {"R", rig.roller.radius, "m"},
                      {"W", pivot_amplitude(rig).result, "m"}},
                     [](const auto& x) { return x[0] * x[2] / x[1]; });
}

Calculation wobble_ratio(const RollingRig& rig) {
    return calculate("wobble_ratio", "DU R/(mu a^2)", "DU R/(mu a^2)", "(3.1.5)", "1",
                     {{"DU", rig.pivot->displacement, "m"},
                      {"R", rig.roller.radius, "m"},
                      {"mu", rig.friction_coefficient, "1"},
                      {"a", reference_radius(rig), "m"}},
                     [](const auto& x) { return x[0] * x[1] / (x[2] * x[3] * x[3]); });
}

bool below_resonance(const double& ratio) {
    return ratio > 1;
}

// Of f_1/f_0.
constexpr Sentence<double> inertia_sentences[] = {
    {below_resonance,
     [](const double& ratio) {
         // x/(1 - x), x = (f_0/f_1)^2: an undamped oscillator driven at its base
         return fmt::format(
             "Without damping inertia of the rig changes the motion by {}: the fastest oscillation "
             "is {} times slower than the lowest eigenfrequency.",
             percent_text(1 / (ratio * ratio - 1), 2), significant(ratio, 3));
     }},
    {[](const double& ratio) { return !below_resonance(ratio); },
     [](const double& ratio) {
         return fmt::format(
             "The fastest oscillation is {} times as fast as the lowest eigenfrequency: inertia of "
             "the rig decides its motion.",
             significant(1 / ratio, 3));
     }}};

}  // namespace

Assumption quasi_static_drive(const RollingRig& rig) {
    Assumption a{
        .name = "quasi_static_drive",
        .title = "Quasi-static drive",
        .claim = "The drive is quasi-static: inertia of the rig and elastic waves are negligible",
        .background = {smallest_amplitude(rig), excitation_frequency(rig)}};
    const statistics::Uncertain f0 = a.background.back().result;
    if (const auto* frequency = find_printed(rig, "excitation_frequency"))
        a.background.push_back(drive_speed(rig, *frequency));
    using enum Criterion::Relation;
    if (rig.drive.eigenfrequency)
        a.criteria.push_back({frequency_ratio(rig, f0), at_least, least_frequency_ratio,
                              "inertia changes the motion by (f_0/f_1)^2: 1 % at 10"});
    else
        a.missing.push_back("drive.eigenfrequency");
    if (rig.substrate.density)
        a.criteria.push_back({wave_ratio(rig, f0), at_least, least_wave_ratio,
                              "shear waves cross the contact a hundred times within a period"});
    else
        a.missing.push_back("substrate.density");
    if (rig.drive.eigenfrequency)
        a.consequence = told(inertia_sentences, a.criteria.front().calculation.result.value);
    return a;
}

Assumption ideal_rolling(const RollingRig& rig) {
    Assumption a{
        "ideal_rolling", "Ideal rolling",
        "The lever's pivot is level with the contact: rolling alone does not move the substrate"};
    if (!rig.pivot) {
        a.missing = {"pivot.displacement"};
        return a;
    }
    a.criteria.push_back({wobble_ratio(rig), Criterion::Relation::at_most, largest_wobble,
                          "measured shifts are of the order mu a^2/R"});
    a.background.push_back(pivot_amplitude(rig));
    a.background.push_back(pivot_height_error(rig));
    if (const auto* height = find_printed(rig, "pivot_height_error"))
        a.background.push_back(pivot_displacement(rig, *height));
    a.consequence = fmt::format(
        "Shifts wobble by {} of mu a^2/R within a period; read with the roller upright they are "
        "not touched.",
        percent_text(a.criteria.front().calculation.result.value, 2));
    return a;
}

}  // namespace tricontact::experiments
