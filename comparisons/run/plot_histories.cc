#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/quantities/model_assumptions.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/plots.h"
#include "report/format.h"
#include "report/plot_style.h"

namespace tricontact::comparisons {

namespace {

using contact::History;

constexpr std::size_t most_steps_drawn = 3000;  // of a thin line: more than the picture has pixels
constexpr std::size_t most_markers = 60;        // beyond, markers merge into a band

/// Every step as (phase, U/unit).
std::string step_data(const std::string& name, const History& history, double unit) {
    std::vector<std::vector<double>> columns(2);
    for (const std::size_t i : report::thinned(history.steps.size(), most_steps_drawn)) {
        columns[0].push_back(history.steps[i].phase);
        columns[1].push_back(history.steps[i].shift[0] / unit);
    }
    return report::data_block(name, columns);
}

/// The upright states as (n, U/unit), n = 0 after loading.
std::string period_data(const std::string& name, const History& history, double unit) {
    std::vector<std::vector<double>> columns{{0.0}, {history.static_shift / unit}};
    for (std::size_t n = 0; n < history.shift_per_period.size(); ++n) {
        columns[0].push_back(static_cast<double>(n + 1));
        columns[1].push_back(history.shift_per_period[n] / unit);
    }
    return report::data_block(name, columns);
}

double last_phase(const Histories& histories) {
    double last = 0;
    for (const History& history : histories)
        for (const auto& step : history.steps) last = std::max(last, step.phase);
    return last;
}

/// Where the curves are not: below a shift that settles, above one that grows.
const char* key_position(const Histories& histories) {
    const bool grows = std::any_of(histories.begin(), histories.end(), [](const History& history) {
        if (history.steps.empty()) return false;
        const double half = history.steps[history.steps.size() / 2].shift[0];
        return history.steps.back().shift[0] > 1.2 * half;
    });
    return grows ? "top left" : "bottom right";
}

std::string model_curves(std::size_t i, const History& history) {
    const std::size_t periods = history.shift_per_period.size();
    const std::size_t every = std::max<std::size_t>(1, (periods + most_markers) / most_markers);
    return fmt::format(
        "$steps{0} using 1:2 with lines linewidth 1 linecolor rgb '{1}' notitle, "
        "$upright{0} every {4} using 1:2 with points pointtype {2} pointsize 0.7 "
        "linecolor rgb '{1}' title '{3}'",
        i, report::model_colour(i), report::model_marker(i), report::display_name(history.model),
        every);
}

/// Shifts in what `unit_of` says of each model's U_max [m]; theory's U_max is that of the
/// half-space.
template <class UnitOf>
std::string shift_script(const contact::Case& c, const Histories& histories, const UnitOf& unit_of,
                         const std::string& label) {
    const Reference r = reference(c);
    const double theory_unit = r.hertz.unit_shift / unit_of(r.hertz.unit_shift);
    double top = theory_unit * std::max(r.static_shift_ratio, r.shakedown_shift_ratio.value_or(0));
    std::string data, curves;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const double unit = unit_of(histories[i].scales.unit_shift);
        for (const auto& step : histories[i].steps) top = std::max(top, step.shift[0] / unit);
        data += step_data(fmt::format("$steps{}", i), histories[i], unit);
        data += period_data(fmt::format("$upright{}", i), histories[i], unit);
        curves += model_curves(i, histories[i]) + ", ";
    }
    if (r.shakedown_shift_ratio)
        curves += fmt::format(
            "{} with lines dashtype 2 linewidth 1.4 linecolor rgb '{}' title "
            "'u_{{sd}}, {}', ",
            theory_unit * *r.shakedown_shift_ratio, report::theory_colour,
            c.is_line_contact() ? "exact, half-space" : "MDR closed form");
    if (r.static_shift_ratio > 0)
        curves += fmt::format(
            "{} with lines dashtype 3 linewidth 1.4 linecolor rgb '{}' title "
            "'u_{{stat}}, {}{}'",
            theory_unit * r.static_shift_ratio, report::theory_colour, static_theory(c),
            static_shift_is_relaxed(c) ? "" : ", relaxed");
    if (curves.ends_with(", ")) curves.resize(curves.size() - 2);
    return data + report::plot_style() +
           fmt::format(
               "set xlabel 'rolling periods n'\n"
               "set ylabel '{}'\n"
               "set xrange [0:{}]\nset yrange [0:{}]\n"
               "set key {} opaque\n"
               "plot {}\n",
               label, last_phase(histories), top > report::negligible_ratio ? 1.08 * top : 1.0,
               key_position(histories), curves);
}

}  // namespace

std::vector<Plot> shift_plots(const contact::Case& c, const Histories& histories) {
    if (last_phase(histories) <= 0) return {};
    const report::Unit unit = report::fitting_unit(histories.front().scales.unit_shift, "m");
    const std::string steps = "Thin lines: every step; markers: indenter upright.";
    return {{"shift",
             "Shift through the rolling periods",
             steps,
             {640, 420,
              shift_script(
                  c, histories, [&unit](double) { return unit.factor; },
                  "shift U [" + unit.symbol + "]")}},
            {"shift_ratio",
             "Shift over U_max through the rolling periods",
             steps + " Each model's shift is over its own unit U_max.",
             {640, 420,
              shift_script(
                  c, histories, [](double unit_shift) { return unit_shift; },
                  "shift u = U / U_{max}")}}};
}

std::vector<Plot> dissipation_plots(const contact::Case& c, const Histories& histories) {
    std::string data, curves;
    std::size_t most_periods = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const QuantityValue value = quantities::dissipation_ratio_per_period.of({c, histories[i]});
        const auto& work = std::get<Numbers>(value);
        std::vector<std::vector<double>> columns(2);
        for (std::size_t n = 0; n < work.size(); ++n) {
            // The axis is logarithmic: periods without dissipation have no place on it.
            if (!(work[n].value_or(0) > 0)) continue;
            columns[0].push_back(static_cast<double>(n + 1));
            columns[1].push_back(*work[n]);
            most_periods = std::max(most_periods, n + 1);
        }
        if (columns[0].empty()) continue;
        data += report::data_block(fmt::format("$work{}", i), columns);
        curves += fmt::format(
            "{}$work{} using 1:2 with linespoints linewidth 1 pointtype {} pointsize 0.7 "
            "linecolor rgb '{}' title '{}'",
            curves.empty() ? "" : ", ", i, report::model_marker(i), report::model_colour(i),
            report::display_name(histories[i].model));
    }
    if (curves.empty()) return {};
    const std::string script = data + report::plot_style() +
                               fmt::format(
                                   "set xlabel 'rolling period n'\n"
                                   "set ylabel 'work per period W_{{fric}} / W_0' offset -0.3,0\n"
                                   "set logscale y\nset format y '10^{{%T}}'\n"
                                   "set xrange [0:{}]\nset key top right opaque\nplot {}\n",
                                   most_periods + 1, curves);
    return {{"dissipation",
             "Frictional work per period",
             fmt::format(
                 "Over W₀, the work of one cycle of a tangential force oscillating between "
                 "±F_T ({}). Periods without any dissipation are not drawn.",
                 c.is_line_contact() ? "line contact, Masing’s rule" : "Mindlin and Deresiewicz"),
             {640, 400, script}}};
}

}  // namespace tricontact::comparisons
