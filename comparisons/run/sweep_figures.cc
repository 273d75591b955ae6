#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "comparisons/run/sweep_document.h"
#include "contact/base/special_values.h"
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

std::string value_text(const Sweep::Point& point, std::size_t axis) {
    const auto* number = std::get_if<double>(&point.values[axis]);
    return number ? report::csv_field(*number) : std::get<std::string>(point.values[axis]);
}

/// All that a point has besides one axis: points that agree in it lie on one line.
std::string rest_of(const Sweep::Point& point, std::size_t axis) {
    std::string rest;
    for (std::size_t i = 0; i < point.values.size(); ++i)
        if (i != axis) rest += value_text(point, i) + '\n';
    return rest;
}

/// Whether no point lacks the quantity: nothing has to be said of where it is defined.
bool sweep_has_all(const Sweep& sweep, const Quantity& quantity) {
    return std::ranges::all_of(sweep.points, [&](const Sweep::Point& point) {
        return std::isfinite(value_of(point, quantity));
    });
}

/// In which the values of a quantity with a unit are drawn.
report::Unit unit_over(const Sweep& sweep, const Quantity& quantity) {
    if (std::string(quantity.unit).empty()) return {};
    double largest = 0;
    for (const Sweep::Point& point : sweep.points)
        largest = std::max(largest, std::abs(point.results.told(quantity).value_or(0)));
    return report::fitting_unit(largest, quantity.unit);
}

/// The other axes in which points of the finest level differ.
std::vector<std::size_t> further_axes(const Sweep& sweep, std::size_t axis) {
    std::vector<std::size_t> further;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
        std::set<std::string> values;
        for (const Sweep::Point& point : sweep.points) values.insert(value_text(point, i));
        if (i != axis && values.size() > 1) further.push_back(i);
    }
    return further;
}

/// "load.tangential_ratio = 0.3, substrate.thickness [mm] = 4".
std::string detail_of(const std::vector<SweepScale>& scales, const Sweep::Point& point,
                      const std::vector<std::size_t>& further) {
    std::string text;
    for (const std::size_t i : further) {
        const auto* number = std::get_if<double>(&point.values[i]);
        text += fmt::format(
            "{}{} = {}", text.empty() ? "" : ", ", scales[i].heading,
            number ? report::as_given(*number / scales[i].unit.factor) : value_text(point, i));
    }
    return text;
}

/// One curve per model and per line of points that differ in the axis alone, of the finest level.
std::vector<report::Curve> curves_over(const Sweep& sweep, const std::vector<SweepScale>& scales,
                                       std::size_t axis, const Quantity& quantity, double unit) {
    struct Line {
        std::string detail;
        std::map<double, double> values;
    };
    const std::vector<std::size_t> further = further_axes(sweep, axis);
    std::vector<std::string> models;
    std::map<std::string, std::vector<Line>> lines;
    std::map<std::string, std::size_t> places;
    for (const Sweep::Point& point : sweep.points) {
        if (point.level + 1 < sweep.levels) continue;
        if (!lines.contains(point.model)) models.push_back(point.model);
        std::vector<Line>& of_model = lines[point.model];
        const auto [place, is_new] =
            places.try_emplace(point.model + '\n' + rest_of(point, axis), of_model.size());
        if (is_new) of_model.push_back({detail_of(scales, point, further), {}});
        const double x = std::get<double>(point.values[axis]) / scales[axis].unit.factor;
        of_model[place->second].values[x] = value_of(point, quantity) / unit;
    }
    // Samples, of which none lies on a line with another, are one set of points per model.
    const bool are_lines = std::ranges::any_of(lines, [](const auto& of_model) {
        return std::ranges::any_of(of_model.second,
                                   [](const Line& line) { return line.values.size() > 1; });
    });
    std::vector<report::Curve> curves;
    for (const std::string& model : models)
        for (const auto& [detail, values] : lines[model]) {
            const std::string name = report::display_name(model);
            if (are_lines || curves.empty() || curves.back().name != name)
                curves.push_back({.name = name,
                                  .kind = are_lines ? report::Curve::Kind::line_and_points
                                                    : report::Curve::Kind::points,
                                  .detail = are_lines ? detail : ""});
            for (const auto& [x, y] : values) curves.back().add(x, y);
        }
    return curves;
}

/// How far a curve goes up and down, over its largest value.
double movement_of(const report::Curve& curve) {
    double low = INFINITY, high = -INFINITY;
    for (const double y : curve.y)
        if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
    const double size = std::max(std::abs(low), std::abs(high));
    return high > low && size > 0 ? (high - low) / size : 0;
}

/// " (bottom)" and " (top)" where the lines of the first model lie in the order of their values.
std::string order_of(const std::vector<report::Curve>& curves, const Sweep& sweep,
                     const std::vector<SweepScale>& scales, std::size_t further) {
    const auto mean = [](const report::Curve& curve) {
        double sum = 0;
        int n = 0;
        for (const double y : curve.y)
            if (std::isfinite(y)) sum += y, ++n;
        return n > 0 ? sum / n : contact::undefined;
    };
    const SweepScale& scale = scales[further];
    std::vector<double> means;
    for (const double value : scale.values)
        for (const Sweep::Point& point : sweep.points) {
            const auto* number = std::get_if<double>(&point.values[further]);
            if (!number || *number / scale.unit.factor != value) continue;
            const std::string detail = detail_of(scales, point, {further});
            const auto curve = std::ranges::find(curves, detail, &report::Curve::detail);
            if (curve != curves.end()) means.push_back(mean(*curve));
            break;
        }
    std::erase_if(means, [](double value) { return !std::isfinite(value); });
    const std::string first = report::as_given(*scale.values.begin()),
                      last = report::as_given(*scale.values.rbegin());
    const bool rises = std::ranges::is_sorted(means),
               falls = std::ranges::is_sorted(means, std::greater<>());
    if (means.size() < 2 || rises == falls) return first + " to " + last;
    return fmt::format("{} ({}) to {} ({})", first, rises ? "bottom" : "top", last,
                       rises ? "top" : "bottom");
}

std::string caption_of(const Sweep& sweep, const std::vector<SweepScale>& scales, std::size_t axis,
                       const Quantity& quantity, const std::vector<report::Curve>& curves) {
    const bool lines =
        std::ranges::count(curves, report::Curve::Kind::line_and_points, &report::Curve::kind) > 0;
    std::string text = std::string(quantity.meaning);
    const std::vector<std::size_t> further = further_axes(sweep, axis);
    if (lines && further.size() == 1 && scales[further[0]].is_number)
        text += fmt::format(" One line per {}, {}.", scales[further[0]].heading,
                            order_of(curves, sweep, scales, further[0]));
    else if (lines && !further.empty()) {
        std::vector<std::string> keys;
        for (const std::size_t i : further) keys.push_back(sweep.axes[i].key);
        text += fmt::format(" One line per value of {}; the pointer and the data give the values.",
                            fmt::join(keys, " and "));
    }
    if (sweep.levels > 1) text += fmt::format(" The finest of {} levels.", sweep.levels);
    if (std::string(quantity.defined) != "always" && !sweep_has_all(sweep, quantity))
        text += fmt::format(" Defined {}.", quantity.defined);
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
        figure.curves = curves_over(sweep, scales, axis, quantity, unit.factor);
        figure.caption = caption_of(sweep, scales, axis, quantity, figure.curves);
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

std::optional<report::Figure> opening_figure(const std::vector<report::DocumentSection>& sections) {
    const report::Figure* chosen = nullptr;
    double most = 1e-6;  // below it is rounding
    // Of the shifts in their order the first that a key moves; of its figures the key that moves it
    // most: the median of its lines.
    for (const char* key : {quantities::settled_shift.key, quantities::shift_increment.key,
                            quantities::settled_shift_ratio.key, quantities::static_shift.key, ""})
        for (const report::DocumentSection& section : sections) {
            if (*key != 0 && section.id != key) continue;
            for (const report::Figure& figure : section.figures) {
                std::vector<double> moved;
                for (const report::Curve& curve : figure.curves)
                    if (curve.x.size() > 1) moved.push_back(movement_of(curve));
                if (moved.empty()) continue;
                std::ranges::sort(moved);
                if (moved[moved.size() / 2] > most)
                    most = moved[moved.size() / 2], chosen = &figure;
            }
            if (chosen && *key != 0) return *chosen;
        }
    return chosen ? std::optional(*chosen) : std::nullopt;
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
