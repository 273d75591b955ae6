#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"
#include "walking/report/walk_document.h"

namespace tricontact::walking {

namespace {

report::Figure spectrum_figure(const Vibration& vibration) {
    constexpr double shown = 4;  // times the frequency of free flight
    report::Curve amplitudes{.name = "amplitude of f_s"};
    const statistics::Spectrum& spectrum = vibration.spectrum;
    for (std::size_t i = 0; i < spectrum.amplitudes.size(); ++i) {
        const double frequency = static_cast<double>(i) * spectrum.resolution;
        if (frequency > shown * vibration.free_flight) break;
        amplitudes.add(frequency, spectrum.amplitudes[i]);
    }
    const double top = std::ranges::max(amplitudes.y);
    return {.id = "spectrum",
            .title = "Spectrum of the spring force",
            .caption =
                "Amplitudes of sines in f_s over the force of steady sliding, root mean square "
                "over eight parts of the recorded end under a Hann window: twice the modulus of "
                "Wetter (2016), eq. 5.2.31.",
            .x = {"frequency [√(k_x/m)]"},
            .y = {"amplitude [-]"},
            .curves = {amplitudes,
                       upright("characteristic", vibration.characteristic.frequency, top, 1),
                       upright("free flight", vibration.free_flight, top)}};
}

report::Figure variance_figure(const Vibration& vibration) {
    constexpr std::size_t enough = 1000;
    const std::size_t stride = 1 + vibration.variances.size() / enough;
    report::Curve variance{.name = "variance of f_s"};
    for (std::size_t i = 0; i < vibration.variances.size(); i += stride)
        variance.add(static_cast<double>(i) * vibration.interval + vibration.window / 2,
                     vibration.variances[i]);
    report::Curve threshold{.name = "threshold",
                            .x = {variance.x.front(), variance.x.back()},
                            .y = {instability_threshold, instability_threshold},
                            .theory = true};
    return {.id = "variance",
            .title = "Running variance",
            .caption = fmt::format("Of the spring force over that of steady sliding, in windows of "
                                   "ten characteristic periods, {}; of squared deviations.",
                                   report::significant(vibration.window, 3)),
            .x = {"time t* = t - t_0 [√(m/k_x)]"},
            .y = {"variance [-]"},
            .curves = {variance, threshold}};
}

/// Frequencies side by side, in hertz too where the case has dimensions.
report::DocumentTable frequency_table(const WalkReport& report, const Vibration& vibration) {
    report::DocumentTable table{.id = "frequencies",
                                .title = "Characteristic frequency",
                                .note =
                                    "Cycles per unit of time √(m/k_x); error: 95 % interval from "
                                    "eight parts. Free flight: √(κ_1 (1 + κ_3² κ_8²/κ_7))/2π.",
                                .columns = {{"frequency"}, {"[√(k_x/m)]"}}};
    const auto& dimensional = report.walk_case.dimensional;
    const double second = dimensional ? 1 / characteristic_time(*dimensional) : 0;
    if (dimensional) table.columns.push_back({"[Hz]"});
    const auto add = [&](const std::string& name, double frequency, double error) {
        table.rows.push_back({name, report::WithError{frequency, error}});
        if (dimensional)
            table.rows.back().emplace_back(report::WithError{frequency * second, error * second});
    };
    const auto& [frequency, error] = vibration.characteristic;
    add("of the spring force, most of the vibration", frequency, error);
    if (const auto period = report.walk.result.period)
        add("of the limit cycle", 1 / *period, report.walk.result.period_error / *period / *period);
    add("of free flight", vibration.free_flight, 0);
    return table;
}

/// Set 5 of Wetter (2016), table 4.3.2, in the prism, at any velocity, weight and height of the
/// spring. The tables have three digits, kappa1 is rounded from 1.96 to 2.
bool is_set_5(const Machine& machine) {
    const Kappas& k = machine.kappas;
    const auto near = [](double value, double printed) {
        return std::abs(value / printed - 1) < 0.03;
    };
    return machine.model == Machine::Model::prism && near(k.kappa1, 2) && near(k.kappa2, 1.33) &&
           near(k.kappa3, 1.51) && near(k.kappa5, 0.75) && near(k.kappa7, 1.77);
}

}  // namespace

report::DocumentSection vibration_section(const WalkReport& report, const Vibration& vibration) {
    report::DocumentSection section{.id = "vibration",
                                    .heading = "Vibration of the spring force",
                                    .figures = {spectrum_figure(vibration)},
                                    .tables = {frequency_table(report, vibration)}};
    if (is_set_5(report.walk_case.machine))
        section.paragraphs.push_back(
            fmt::format("Wetter (2016), eq. 5.2.36, has 0.1 ± 0.006 for his simulations of set 5 "
                        "and derives the characteristic time and k_x = m/τ² of the rig from it. "
                        "Here it is {}: the same measured frequency gives a k_x that differs by "
                        "the inverse square of the ratio of both.",
                        report::with_error(vibration.characteristic.frequency,
                                           vibration.characteristic.error)));
    if (!vibration.variances.empty()) section.figures.push_back(variance_figure(vibration));
    return section;
}

}  // namespace tricontact::walking
