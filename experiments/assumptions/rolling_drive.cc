// What the drive does: slowly enough, and rolling only.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/number_text.h"
#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

using contact::significant;

// Inertia changes an amplitude by (f_0/f_1)^2: 1 % at 10.
constexpr double least_frequency_ratio = 10;
constexpr double least_wave_ratio = 100;
constexpr double largest_wobble = 0.01;

double product(const Values& x) {
    return x[0] * x[1];
}

constexpr Formula smallest_amplitude("smallest_amplitude", "W", "w a", "(3.1.4)", "m", "w a'",
                                     product);
constexpr Formula pivot_amplitude("pivot_amplitude", "W", "w a", "(3.1.4)", "m", "w' a'", product);

constexpr Formula wobble_ratio("wobble_ratio", "DU R/(mu a^2)", "DU R/(mu a^2)", "(3.1.5)", "1",
                               "DU R mu a'",
                               [](const Values& x) { return x[0] * x[1] / (x[2] * x[3] * x[3]); });

// Of f_1/f_0.
constexpr contact::Sentence<double> inertia_sentences[] = {
    {[](const double& ratio) { return ratio > 1; },
     [](const double& ratio) {
         // x/(1 - x), x = (f_0/f_1)^2: an undamped oscillator driven at its base
         return fmt::format(
             "Without damping inertia of the rig changes the motion by {}: the fastest oscillation "
             "is {} times slower than the lowest eigenfrequency.",
             percent_text(1 / (ratio * ratio - 1), 2), significant(ratio, 3));
     }},
    {[](const double& ratio) { return !(ratio > 1); },
     [](const double& ratio) {
         return fmt::format(
             "The fastest oscillation is {} times as fast as the lowest eigenfrequency: inertia of "
             "the rig decides its motion.",
             significant(1 / ratio, 3));
     }}};

std::vector<Given> joined(std::vector<Given> some, const std::vector<Given>& more) {
    some.insert(some.end(), more.begin(), more.end());
    return some;
}

/// Of the printed value of this name, if the rig has it.
std::vector<Given> printed_given(const RollingRig& rig, const char* name, const char* symbol,
                                 const char* unit) {
    const auto found = std::ranges::find(rig.printed, name, &PrintedValue::name);
    if (found == rig.printed.end()) return {};
    return {{symbol, found->value, unit}};
}

}  // namespace

Assumption quasi_static_drive(const RollingRig& rig) {
    using enum Criterion::Relation;
    const Calculation amplitude = calculate(rig, smallest_amplitude);
    const std::vector<Given> w{{"W", amplitude.result, "m"}};
    const Calculation excitation =
        calculate("excitation_frequency", "f_0", "v/(4 W)", "section 5.1.5", "Hz",
                  joined(given(rig, "v"), w), [](const auto& x) { return x[0] / (4 * x[1]); });
    const std::vector<Given> f0{{"f_0", excitation.result, "Hz"}};
    Assumption a{
        .name = "quasi_static_drive",
        .title = "Quasi-static drive",
        .claim = "The drive is quasi-static: inertia of the rig and elastic waves are negligible",
        .background = {amplitude, excitation}};
    // The speed that belongs to the printed frequency.
    if (const auto print = printed_given(rig, "excitation_frequency", "f_0", "Hz"); !print.empty())
        a.background.push_back(calculate("drive_speed", "v", "4 W f_0, f_0 as printed",
                                         "section 5.1.5", "m/s", joined(w, print),
                                         [](const auto& x) { return 4 * x[0] * x[1]; }));
    if (rig.drive.eigenfrequency) {
        a.criteria.push_back(
            {calculate("frequency_ratio", "f_1/f_0", "f_1/f_0", "section 5.1.5", "1",
                       joined(given(rig, "f_1"), f0), [](const auto& x) { return x[0] / x[1]; }),
             at_least, least_frequency_ratio,
             "inertia changes the motion by (f_0/f_1)^2: 1 % at 10"});
        a.consequence = told(inertia_sentences, a.deciding_value());
    } else {
        a.missing.push_back("drive.eigenfrequency");
    }
    if (rig.substrate.density)
        a.criteria.push_back(
            {calculate("wave_ratio", "T_c c_s/D_c",
                       "sqrt(G_2/rho)/(f_0 D_c), G_2 = E_2/(2 (1 + nu_2)), D_c = 2 a", "(2.3.1)",
                       "1", joined(joined(given(rig, "E_2 nu_2 rho"), f0), given(rig, "a")),
                       [](const auto& x) {
                           return std::sqrt(x[0] / (2 * (1 + x[1])) / x[2]) / (x[3] * 2 * x[4]);
                       }),
             at_least, least_wave_ratio,
             "shear waves cross the contact a hundred times within a period"});
    else
        a.missing.push_back("substrate.density");
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
    a.criteria.push_back({calculate(rig, wobble_ratio), Criterion::Relation::at_most,
                          largest_wobble, "measured shifts are of the order mu a^2/R"});
    a.background.push_back(calculate(rig, pivot_amplitude));
    const std::vector<Given> w{{"W", a.background.back().result, "m"}};
    a.background.push_back(calculate("pivot_height_error", "Dh", "DU R/W", "(5.1.11)", "m",
                                     joined(given(rig, "DU R"), w),
                                     [](const auto& x) { return x[0] * x[1] / x[2]; }));
    // What the printed height error would do.
    if (const auto print = printed_given(rig, "pivot_height_error", "Dh", "m"); !print.empty())
        a.background.push_back(calculate("pivot_displacement", "DU", "Dh W/R, Dh as printed",
                                         "(5.1.11)", "m", joined(joined(print, given(rig, "R")), w),
                                         [](const auto& x) { return x[0] * x[2] / x[1]; }));
    a.consequence = fmt::format(
        "Shifts wobble by {} of mu a^2/R within a period; read with the roller upright they are "
        "not touched.",
        percent_text(a.deciding_value(), 2));
    return a;
}

}  // namespace tricontact::experiments
