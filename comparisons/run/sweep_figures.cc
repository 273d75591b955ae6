#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "comparisons/run/sweep_document.h"
#include "contact/special_values.h"
#include "report/csv.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

double value_of(const Sweep::Point& point, const Quantity& quantity) {
    return point.results.told(quantity).value_or(contact::undefined);
}

/// "Settled shift u_sd".
std::string title_of(const Quantity& quantity) {
    return report::capitalised(label_of(quantity));
}

SweepScale scale_of(const Sweep& sweep, std::size_t axis) {
    const auto& [key, base, logarithmic] = sweep.axes[axis];
    SweepScale scale{.heading = key};
    std::set<double> values;
    for (const Sweep::Point& point : sweep.points) {
        const auto* value = std::get_if<double>(&point.values[axis]);
        if (!value) return {.heading = key, .is_number = false};
        values.insert(*value);
    }
    const double largest =
        values.empty() ? 0 : std::max(std::abs(*values.begin()), std::abs(*values.rbegin()));
    if (base == "rad")
        scale.unit = {std::numbers::pi / 180, "°"};
    else if (!base.empty())
        scale.unit = report::fitting_unit(largest, base);
    if (!scale.unit.symbol.empty()) scale.heading += " [" + scale.unit.symbol + "]";
    for (const double value : values) scale.values.insert(value / scale.unit.factor);
    return scale;
}

/// All that a point has besides one axis: points that agree in it lie on one line.
std::string rest_of(const Sweep::Point& point, std::size_t axis) {
    std::string rest;
    for (std::size_t i = 0; i < point.values.size(); ++i) {
        if (i == axis) continue;
        const auto* number = std::get_if<double>(&point.values[i]);
        rest +=
            (number ? report::csv_field(*number) : std::get<std::string>(point.values[i])) + '\n';
    }
    return rest;
}

/// In which the values of a quantity with a unit are drawn.
report::Unit unit_over(const Sweep& sweep, const Quantity& quantity) {
    if (std::string(quantity.unit).empty()) return {};
    double largest = 0;
    for (const Sweep::Point& point : sweep.points)
        largest = std::max(largest, std::abs(point.results.told(quantity).value_or(0)));
    return report::fitting_unit(largest, quantity.unit);
}

/// One curve per model and level, its lines apart by gaps.
std::vector<report::Curve> curves_over(const Sweep& sweep, std::size_t axis,
                                       const SweepScale& scale, const Quantity& quantity,
                                       double unit) {
    std::vector<std::string> names;
    std::map<std::string, std::map<std::string, std::map<double, double>>> lines;
    for (const Sweep::Point& point : sweep.points) {
        const std::string name = name_of(point, sweep);
        if (!lines.contains(name)) names.push_back(name);
        const double x = std::get<double>(point.values[axis]) / scale.unit.factor;
        lines[name][rest_of(point, axis)][x] = value_of(point, quantity) / unit;
    }
    std::vector<report::Curve> curves;
    for (const std::string& name : names) {
        report::Curve curve{.name = name, .x = {}, .y = {}, .kind = report::Curve::Kind::points};
        for (const auto& [rest, line] : lines[name]) {
            if (line.size() > 1) curve.kind = report::Curve::Kind::line_and_points;
            if (!curve.x.empty()) curve.add(contact::undefined, contact::undefined);
            for (const auto& [x, y] : line) curve.add(x, y);
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

std::string caption_of(const Sweep& sweep, const Quantity& quantity,
                       const std::vector<report::Curve>& curves) {
    const bool lines =
        std::ranges::count(curves, report::Curve::Kind::line_and_points, &report::Curve::kind) > 0;
    std::string text = std::string(quantity.meaning) + " ";
    if (lines && sweep.axes.size() > 1) text += "Lines join points that differ in nothing else. ";
    if (std::string(quantity.defined) != "always")
        text += fmt::format("Defined {}. ", quantity.defined);
    text.pop_back();
    return text;
}

std::vector<report::Figure> figures_of(const Sweep& sweep, const std::vector<SweepScale>& scales,
                                       const Quantity& quantity) {
    const bool defined = std::ranges::any_of(sweep.points, [&](const Sweep::Point& point) {
        return std::isfinite(value_of(point, quantity));
    });
    const report::Unit unit = unit_over(sweep, quantity);
    std::vector<report::Figure> figures;
    if (!defined || sweep.points.size() > most_drawn) return figures;
    for (std::size_t axis = 0; axis < sweep.axes.size(); ++axis) {
        const SweepScale& scale = scales[axis];
        if (!scale.is_number || scale.values.size() < 2) continue;
        const std::string& key = sweep.axes[axis].key;
        report::Figure& figure = figures.emplace_back();
        figure.id = fmt::format("{}_{}", quantity.key, axis + 1);
        figure.title = fmt::format("{} over {}", title_of(quantity), key);
        figure.x = {scale.heading, sweep.axes[axis].logarithmic};
        figure.y.label = unit.symbol.empty() ? heading_of(quantity)
                                             : fmt::format("{} [{}]", quantity.symbol, unit.symbol);
        figure.curves = curves_over(sweep, axis, scale, quantity, unit.factor);
        figure.caption = caption_of(sweep, quantity, figure.curves);
    }
    return figures;
}

}  // namespace

std::vector<SweepScale> scales_of(const Sweep& sweep) {
    std::vector<SweepScale> scales;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) scales.push_back(scale_of(sweep, i));
    return scales;
}

std::string name_of(const Sweep::Point& point, const Sweep& sweep) {
    const std::string model = report::display_name(point.model);
    return sweep.levels == 1 ? model : fmt::format("{}, level {}", model, point.level);
}

std::vector<report::DocumentSection> shift_sections(const Sweep& sweep,
                                                    const std::vector<SweepScale>& scales) {
    std::vector<report::DocumentSection> sections;
    for (const Quantity* quantity : all_quantities()) {
        if (!quantity->is_plotted) continue;
        std::vector<report::Figure> figures = figures_of(sweep, scales, *quantity);
        if (figures.empty()) continue;
        sections.push_back({quantity->key, title_of(*quantity), {}, std::move(figures)});
    }
    return sections;
}

}  // namespace tricontact::comparisons
