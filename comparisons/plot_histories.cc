#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparisons/format.h"
#include "comparisons/model_assumptions.h"
#include "comparisons/plot_style.h"
#include "comparisons/plots.h"
#include "comparisons/reference.h"
#include "comparisons/summary.h"

namespace tricontact::comparisons {

namespace {

using contact::History;

constexpr std::size_t most_points = 3000;  // of a thin line: more than the picture has pixels
constexpr std::size_t most_markers = 60;   // beyond, markers merge into a band

/// Every step as (phase, u).
std::string step_data(const std::string& name, const History& history) {
    std::vector<std::vector<double>> columns(2);
    for (const std::size_t i : thinned(history.steps.size(), most_points)) {
        columns[0].push_back(history.steps[i].phase);
        columns[1].push_back(history.steps[i].shift[0] / history.scales.unit_shift);
    }
    return data_block(name, columns);
}

/// The upright states as (n, u), n = 0 after loading.
std::string period_data(const std::string& name, const ModelSummary& summary) {
    std::vector<std::vector<double>> columns{{0.0}, {summary.static_shift_ratio}};
    for (std::size_t n = 0; n < summary.shift_ratio_per_period.size(); ++n) {
        columns[0].push_back(static_cast<double>(n + 1));
        columns[1].push_back(summary.shift_ratio_per_period[n]);
    }
    return data_block(name, columns);
}

double last_phase(const Histories& histories) {
    double last = 0;
    for (const History& history : histories)
        for (const auto& step : history.steps) last = std::max(last, step.phase);
    return last;
}

double largest_shift_ratio(const Histories& histories) {
    double largest = 0;
    for (const History& history : histories)
        for (const auto& step : history.steps)
            largest = std::max(largest, step.shift[0] / history.scales.unit_shift);
    return largest;
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

std::string model_curves(std::size_t i, const ModelSummary& summary) {
    const std::size_t periods = summary.shift_ratio_per_period.size();
    const std::size_t every = std::max<std::size_t>(1, (periods + most_markers) / most_markers);
    return fmt::format(
        "$steps{0} using 1:2 with lines linewidth 1 linecolor rgb '{1}' notitle, "
        "$upright{0} every {4} using 1:2 with points pointtype {2} pointsize 0.7 "
        "linecolor rgb '{1}' title '{3}'",
        i, model_colour(i), model_marker(i), display_name(summary.model), every);
}

}  // namespace

std::vector<Plot> shift_plots(const contact::Case& c, const Histories& histories) {
    const double end = last_phase(histories);
    if (end <= 0) return {};
    const Reference theory = reference(c);
    const double top = std::max({largest_shift_ratio(histories), theory.static_shift_ratio,
                                 theory.shakedown_shift_ratio.value_or(0)});
    std::string data, curves;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const ModelSummary summary = summarise(c, histories[i]);
        data += step_data(fmt::format("$steps{}", i), histories[i]);
        data += period_data(fmt::format("$upright{}", i), summary);
        curves += model_curves(i, summary) + ", ";
    }
    if (theory.shakedown_shift_ratio)
        curves += fmt::format(
            "{} with lines dashtype 2 linewidth 1.4 linecolor rgb '{}' title "
            "'u_{{sd}}, {}', ",
            *theory.shakedown_shift_ratio, theory_colour,
            c.is_line_contact() ? "exact, half-space" : "MDR closed form");
    if (theory.static_shift_ratio > 0)
        curves += fmt::format(
            "{} with lines dashtype 3 linewidth 1.4 linecolor rgb '{}' title "
            "'u_{{stat}}, {}{}'",
            theory.static_shift_ratio, theory_colour, static_theory(c),
            static_shift_is_relaxed(c) ? "" : ", relaxed");
    if (curves.ends_with(", ")) curves.resize(curves.size() - 2);
    const std::string script =
        data + plot_style() +
        fmt::format(
            "set xlabel 'rolling periods n'\n"
            "set ylabel 'shift u = U / U_{{max}}'\n"
            "set xrange [0:{}]\nset yrange [0:{}]\n"
            "set key {} opaque\n"
            "plot {}\n",
            end, top > negligible_ratio ? 1.08 * top : 1.0, key_position(histories), curves);
    return {
        {"shift",
         "Rigid shift through the rolling periods",
         "Thin lines: every step; markers: indenter upright. Each model's shift is over its own "
         "unit U_max.",
         {640, 420, script}}};
}

std::vector<Plot> dissipation_plots(const contact::Case& c, const Histories& histories) {
    std::string data, curves;
    std::size_t most_periods = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const ModelSummary summary = summarise(c, histories[i]);
        std::vector<std::vector<double>> columns(2);
        for (std::size_t n = 0; n < summary.dissipation_ratio_per_period.size(); ++n) {
            // The axis is logarithmic: periods without dissipation have no place on it.
            if (!(summary.dissipation_ratio_per_period[n].value_or(0) > 0)) continue;
            columns[0].push_back(static_cast<double>(n + 1));
            columns[1].push_back(*summary.dissipation_ratio_per_period[n]);
            most_periods = std::max(most_periods, n + 1);
        }
        if (columns[0].empty()) continue;
        data += data_block(fmt::format("$work{}", i), columns);
        curves += fmt::format(
            "{}$work{} using 1:2 with linespoints linewidth 1 pointtype {} pointsize 0.7 "
            "linecolor rgb '{}' title '{}'",
            curves.empty() ? "" : ", ", i, model_marker(i), model_colour(i),
            display_name(summary.model));
    }
    if (curves.empty()) return {};
    const std::string script = data + plot_style() +
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
