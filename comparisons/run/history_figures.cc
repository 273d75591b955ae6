#include <fmt/format.h>

#include <algorithm>

#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/figures.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::History;

constexpr double negligible_ratio = 1e-9;       // rounding, not physics: no axis zooms in on it
constexpr std::size_t most_steps_drawn = 3000;  // of a line: more than the picture has pixels
constexpr std::size_t most_markers = 60;        // beyond, markers merge into a band

/// Every step as (phase, U/unit).
report::Curve step_curve(const History& history, double unit) {
    report::Curve curve = curve_of(history);
    for (const std::size_t k : report::thinned(history.steps.size(), most_steps_drawn))
        curve.add(history.steps[k].phase, history.steps[k].shift[0] / unit);
    return curve;
}

/// The upright states as (n, U/unit), n = 0 after loading.
report::Curve period_curve(const History& history, double unit) {
    report::Curve curve = curve_of(history);
    curve.kind = report::Curve::Kind::points;
    const auto& shifts = history.shift_per_period;
    for (const std::size_t n : report::thinned(shifts.size() + 1, most_markers))
        curve.add(static_cast<double>(n), (n == 0 ? history.static_shift : shifts[n - 1]) / unit);
    return curve;
}

double last_phase(const Histories& histories) {
    double last = 0;
    for (const History& history : histories)
        for (const auto& step : history.steps) last = std::max(last, step.phase);
    return last;
}

/// Shifts in what `unit_of` says of each model's U_max [m]; theory's U_max is that of the
/// half-space.
template <class UnitOf>
report::Figure shift_figure(const contact::Case& c, const Histories& histories,
                            const UnitOf& unit_of, report::Figure figure) {
    const Reference r = reference(c);
    const double theory_unit = r.hertz.unit_shift / unit_of(r.hertz.unit_shift);
    const double end = last_phase(histories);
    double bottom = 0;
    double top = theory_unit * std::max(r.static_shift_ratio, r.shakedown_shift_ratio.value_or(0));
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const double unit = unit_of(histories[i].scales.unit_shift);
        for (const auto& step : histories[i].steps) {
            top = std::max(top, step.shift[0] / unit);
            bottom = std::min(bottom, step.shift[0] / unit);
        }
        figure.curves.push_back(step_curve(histories[i], unit));
        if (!histories[i].shift_per_period.empty())
            figure.curves.push_back(period_curve(histories[i], unit));
    }
    // A ratio in small letters, a length in capitals.
    const std::string letter = figure.id == "shift" ? "U" : "u";
    const auto add_theory = [&](const std::string& name, double ratio) {
        figure.curves.push_back({.name = name,
                                 .x = {0, end},
                                 .y = {theory_unit * ratio, theory_unit * ratio},
                                 .theory = true});
    };
    if (r.shakedown_shift_ratio)
        add_theory(
            letter + (c.is_line_contact() ? "_sd, exact, half-space" : "_sd, MDR closed form"),
            *r.shakedown_shift_ratio);
    if (r.static_shift_ratio > 0)
        add_theory(
            letter + "_stat, " + static_theory(c) + (static_shift_is_relaxed(c) ? "" : ", relaxed"),
            r.static_shift_ratio);
    figure.x = {.label = c.prescribed_path ? "row of the path" : "rolling periods n",
                .low = 0,
                .high = end};
    const double margin = 0.08 * (top - bottom);
    const bool is_negative = bottom < -negligible_ratio * std::max(top, theory_unit);
    figure.y.low = is_negative ? bottom - margin : 0;
    figure.y.high = top > negligible_ratio ? top + margin : is_negative ? margin : 1.0;
    return figure;
}

}  // namespace

Figures shift_figures(const contact::Case& c, const Histories& histories,
                      const std::optional<NumericalError>& error) {
    if (last_phase(histories) <= 0) return {};
    const report::Unit unit = report::fitting_unit(histories.front().scales.unit_shift, "m");
    const std::string steps =
        c.prescribed_path ? "Lines: every step." : "Lines: every step; markers: indenter upright.";
    const std::string along = c.prescribed_path ? "along the path" : "through the rolling periods";
    report::Figure metres = shift_figure(c, histories, [&unit](double) { return unit.factor; },
                                         {.id = "shift",
                                          .title = "Shift " + along,
                                          .caption = steps,
                                          .y = {"shift U [" + unit.symbol + "]"}});
    if (error && error->coarser) {
        report::Band band = error->shift_band(unit.factor);
        band.name = report::display_name(error->model);
        metres.caption += " Band: error of mesh and steps in " + band.name + ".";
        for (const double low : band.low)
            if (low < *metres.y.low) metres.y.low = 1.08 * low;
        for (const double high : band.high)
            if (high > *metres.y.high) metres.y.high = 1.08 * high;
        metres.bands.push_back(std::move(band));
    }
    return {std::move(metres),
            shift_figure(c, histories, [](double unit_shift) { return unit_shift; },
                         {.id = "shift_ratio",
                          .title = "Shift over U_max " + along,
                          .caption = steps + " Each model's shift is over its own unit U_max.",
                          .y = {"shift u = U / U_max"}})};
}

Figures dissipation_figures(const contact::Case& c, const Histories& histories) {
    report::Figure figure{
        .id = "dissipation",
        .title = "Frictional work per period",
        .caption = fmt::format(
            "Over W₀, the work of one cycle of a tangential force oscillating between ±F_T ({}). "
            "Periods without any dissipation are not drawn.",
            c.is_line_contact() ? "line contact, Masing’s rule" : "Mindlin and Deresiewicz"),
        .x = {.label = "rolling period n", .low = 0},
        .y = {"work per period W_fric / W_0", true}};
    std::size_t most_periods = 0;
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const QuantityValue value = quantities::dissipation_ratio_per_period.of({c, histories[i]});
        const auto& work = std::get<Numbers>(value);
        report::Curve curve = curve_of(histories[i]);
        curve.kind = report::Curve::Kind::line_and_points;
        for (std::size_t n = 0; n < work.size(); ++n) {
            // The axis is logarithmic: periods without dissipation have no place on it.
            if (!(work[n].value_or(0) > 0)) continue;
            curve.add(static_cast<double>(n + 1), *work[n]);
            most_periods = std::max(most_periods, n + 1);
        }
        if (!curve.x.empty()) figure.curves.push_back(curve);
    }
    if (figure.curves.empty()) return {};
    figure.x.high = static_cast<double>(most_periods + 1);
    return {figure};
}

}  // namespace tricontact::comparisons
