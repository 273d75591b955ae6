#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "report/format.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking {

namespace {

using Run = const WalkSweep::Point*;

constexpr std::array scenarios = {Regime::shakedown, Regime::ratcheting, Regime::walking,
                                  Regime::tilting};

/// A machine under one pull and an excitation that grows.
struct Series {
    double pull = 0;  ///< f = <f_s>/(mu kappa4)
    DriftLimits limits;
    std::vector<Run> runs;  ///< by amplitude

    std::string name() const { return "f = " + report::significant(pull, 2); }
};

/// Of the moment over the weight times b, or of the force over the weight.
double amplitude_of(Run run) {
    const Excitation& excitation = run->machine.excitation;
    return std::max(excitation.moment, excitation.force) / run->machine.kappas.kappa4;
}

Regime regime_of(Run run) {
    return run->outcome->result.regime;
}

/// The axis of the moment or of the force, if it is the only excitation and the base stands still.
std::optional<std::size_t> excited_axis(const WalkSweep& sweep) {
    for (const WalkSweep::Point& point : sweep.points)
        if (point.machine.kappas.kappa6 > 0 ||
            (point.machine.excitation.moment > 0 && point.machine.excitation.force > 0))
            return {};
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        if (sweep.axes[i].key == "excitation.moment" || sweep.axes[i].key == "excitation.force")
            return i;
    return {};
}

/// Runs that differ in nothing but the amplitude, by the pull.
std::vector<Series> series_of(const WalkSweep& sweep, std::size_t axis) {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i)
        if (i != axis) others.push_back(i);
    std::vector<Series> all;
    for (auto& [values, runs] : groups_over(sweep, others)) {
        std::ranges::sort(runs, {}, amplitude_of);
        const auto first = std::ranges::find_if(
            runs, [](Run run) { return run->outcome->result.drift.has_value(); });
        if (first == runs.end()) continue;
        const double pull = (*first)->outcome->result.mu_e;
        all.push_back({pull, drift_limits(runs.back()->machine, pull), std::move(runs)});
    }
    std::ranges::sort(all, {}, &Series::pull);
    return all;
}

/// "ratcheting from m = 0.50 to 0.90"; empty if no run is of that scenario.
std::string range_of(const Series& series, Regime regime) {
    std::vector<double> amplitudes;
    for (const Run run : series.runs)
        if (regime_of(run) == regime) amplitudes.push_back(amplitude_of(run));
    if (amplitudes.empty()) return {};
    const std::string first = report::as_given(amplitudes.front()),
                      last = report::as_given(amplitudes.back());
    const std::string at = first == last ? "at m = " + first : "from m = " + first + " to " + last;
    return fmt::format("{} {}", word_of(regime), at);
}

report::Verdict verdict_of(const Series& series) {
    std::string found;
    for (const Regime regime : scenarios) {
        const std::string range = range_of(series, regime);
        if (!range.empty()) found += (found.empty() ? "" : ", ") + range;
    }
    return {.sentence = fmt::format(
                "Pulled by {}: {}. Quasi-static, it shakes down up to m = {} and a spot "
                "leaves the ground above {}.",
                series.name(), found, report::significant(series.limits.ratcheting, 3),
                report::significant(series.limits.lift_off, 3))};
}

using Value = double (*)(const WalkResult::Drift& drift);

/// Top of a figure: a third above the largest value of a machine that ratchets, if one does. What
/// flies more than it walks would hide all others.
double top_of(const std::vector<Series>& all, Value value) {
    double top = 0;
    for (const Series& series : all)
        for (const Run run : series.runs)
            if (regime_of(run) == Regime::ratcheting)
                top = std::max(top, 4. / 3 * value(*run->outcome->result.drift));
    return top > 0 ? top : 1;
}

report::Curve curve_of(const Series& series, int colour, Value value, double top) {
    report::Curve curve{.name = series.name(), .kind = report::Curve::Kind::line_and_points};
    curve.colour = colour;
    for (const Run run : series.runs) {
        const auto& drift = run->outcome->result.drift;
        if (!drift || value(*drift) > top) continue;
        curve.add(amplitude_of(run), value(*drift));
    }
    return curve;
}

/// Over the amplitude: what the machines do, and where quasi-static ones change their ways.
report::Figure figure_of(const std::vector<Series>& all, report::Figure figure, Value value) {
    figure.caption +=
        " Over m, the moment over the weight times b, or the force over the weight. Dashed, in the "
        "colour of its machine: up to here, m = 1 - f, it shakes down if it is rocked slowly; in "
        "grey: above it a spot leaves the ground. Machines that tilt are left out.";
    figure.x = {"m"};
    const double top = top_of(all, value);
    for (std::size_t i = 0; i < all.size(); ++i)
        figure.curves.push_back(curve_of(all[i], static_cast<int>(i), value, top));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [ratcheting, lift_off] = all[i].limits;
        figure.curves.push_back(
            upright("limit of shakedown", ratcheting, top, static_cast<int>(i)));
        figure.curves.push_back(upright("lift-off", lift_off, top));
    }
    return figure;
}

report::DocumentTable table_of(const std::vector<Series>& all) {
    report::DocumentTable table{
        .id = "scenarios",
        .title = "Shift per period and time in the air",
        .note =
            "Shifts of the base over U_max = μ κ_2 z_stat, over the second half "
            "of the run; in the air: share of time in which a spot, or more, is.",
        .columns = {{"f"}, {"m"}, {"scenario"}, {"shift per period"}, {"in the air [%]"}}};
    for (const Series& series : all)
        for (const Run run : series.runs) {
            const auto& drift = run->outcome->result.drift;
            table.rows.push_back({series.pull, amplitude_of(run),
                                  std::string(word_of(regime_of(run))),
                                  drift ? report::WithError{drift->per_period, drift->error}
                                        : report::WithError{NAN, NAN},
                                  drift ? 100 * drift->airborne : NAN});
        }
    return table;
}

}  // namespace

std::optional<WalkSection> scenarios_section(const WalkSweep& sweep) {
    const auto axis = excited_axis(sweep);
    if (!axis) return {};
    const std::vector<Series> all = series_of(sweep, *axis);
    if (all.empty()) return {};
    WalkSection result{
        .section = {.id = "scenarios", .heading = "Shakedown, ratcheting and walking"}};
    for (const Series& series : all) result.verdicts.push_back(verdict_of(series));
    result.section.figures = {
        figure_of(all,
                  {.id = "shift_per_period",
                   .title = "Shift per period",
                   .caption = "Of the base, over U_max = μ κ_2 z_stat; larger ones of machines in "
                              "flight are in the table.",
                   .y = {"shift per period / U_max"}},
                  [](const WalkResult::Drift& drift) { return drift.per_period; }),
        figure_of(all,
                  {.id = "airborne",
                   .title = "In the air",
                   .caption = "Share of time in which a spot, or more, is in the air.",
                   .y = {"share of time"}},
                  [](const WalkResult::Drift& drift) { return drift.airborne; })};
    result.section.tables = {table_of(all)};
    return result;
}

}  // namespace tricontact::walking
