// The fretting map of a sweep: which regime at which values of its first two axes of numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "comparisons/quantities/quantities.h"
#include "comparisons/run/sweep_document.h"

namespace tricontact::comparisons {

namespace {

constexpr SlipRegime regimes[] = {SlipRegime::stick, SlipRegime::partial_slip, SlipRegime::mixed,
                                  SlipRegime::gross_slip};

/// Value of a point along an axis, in the unit of its scale.
double place_on(const Sweep::Point& point, const std::vector<SweepScale>& scales,
                std::size_t axis) {
    return std::get<double>(point.values[axis]) / scales[axis].unit.factor;
}

const SlipRegime* regime_at(const Sweep::Point& point) {
    return std::get_if<SlipRegime>(&point.results[quantities::path_regime]);
}

/// Points of one model that differ in the two axes alone: the values of all others.
std::string apart_from(const Sweep::Point& point, std::size_t first, std::size_t second) {
    std::string rest = point.model;
    for (std::size_t i = 0; i < point.values.size(); ++i) {
        if (i == first || i == second) continue;
        const auto* number = std::get_if<double>(&point.values[i]);
        rest +=
            '\n' + (number ? report::as_given(*number) : std::get<std::string>(point.values[i]));
    }
    return rest;
}

/// Boundaries of regimes along the first axis, halfway between neighbours that are not alike.
std::vector<report::Curve> boundaries(const std::vector<const Sweep::Point*>& points,
                                      const std::vector<SweepScale>& scales, std::size_t first,
                                      std::size_t second) {
    std::map<double, std::map<double, SlipRegime>> rows;
    for (const Sweep::Point* point : points)
        rows[place_on(*point, scales, second)][place_on(*point, scales, first)] =
            *regime_at(*point);
    std::vector<report::Curve> curves;
    for (const SlipRegime regime : regimes) {
        report::Curve curve{.name = fmt::format("up to {}", name_of(regime))};
        for (const auto& [y, row] : rows)
            for (auto next = std::next(row.begin()); next != row.end(); ++next) {
                const auto before = std::prev(next);
                if (next->second != regime || before->second == regime) continue;
                curve.add((before->first + next->first) / 2, y);
                break;
            }
        if (!curve.x.empty()) curves.push_back(std::move(curve));
    }
    return curves;
}

}  // namespace

std::vector<report::Figure> regime_maps(const Sweep& sweep, const std::vector<SweepScale>& scales) {
    std::vector<std::size_t> axes;
    for (std::size_t i = 0; i < scales.size(); ++i)
        if (scales[i].is_number && scales[i].values.size() > 1) axes.push_back(i);
    if (axes.size() < 2 || sweep.points.size() > most_drawn) return {};
    const std::size_t first = axes[0], second = axes[1];
    std::vector<std::string> names;
    std::map<std::string, std::vector<const Sweep::Point*>> groups;
    for (const Sweep::Point& point : sweep.points) {
        if (point.level + 1 < sweep.levels || !regime_at(point)) continue;
        const std::string name = apart_from(point, first, second);
        if (!groups.contains(name)) names.push_back(name);
        groups[name].push_back(&point);
    }
    std::vector<report::Figure> figures;
    for (const std::string& name : names) {
        const auto& points = groups[name];
        std::string title = report::display_name(points.front()->model);
        if (const auto end = name.find('\n'); end != std::string::npos)
            title += ", " + name.substr(end + 1);
        std::ranges::replace(title, '\n', ' ');
        report::Figure figure{
            .id = fmt::format("regimes_{}", figures.size() + 1),
            .title = "Fretting map, " + title,
            .caption =
                "Regime of all closed cycles of each point (Vingsbo and Söderberg 1988). "
                "Boundaries lie halfway between neighbouring points along the first axis: "
                "they are no better known than these are close.",
            .x = {scales[first].heading, sweep.axes[first].logarithmic},
            .y = {scales[second].heading, sweep.axes[second].logarithmic}};
        for (const SlipRegime regime : regimes) {
            report::Curve curve{.name = name_of(regime), .kind = report::Curve::Kind::points};
            for (const Sweep::Point* point : points)
                if (*regime_at(*point) == regime)
                    curve.add(place_on(*point, scales, first), place_on(*point, scales, second));
            if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
        }
        for (report::Curve& curve : boundaries(points, scales, first, second))
            figure.curves.push_back(std::move(curve));
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace tricontact::comparisons
