#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparisons/finite_strain/strain_output.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

const std::vector<double> strain_levels{-20, -10, -5, -2, -1, 1, 2, 5, 10, 20};  // [%]

const report::FigureAxis force_axis{"normal force F_N [N]", true};

/// Places of the map's points along an axis, increasing.
std::vector<double> places(const StrainDeviation& deviation, double StrainPoint::*of) {
    std::vector<double> values;
    for (const StrainPair& pair : deviation.pairs) values.push_back(pair.point.*of);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

/// [%]; NaN where a run failed or was none.
double percent_at(const StrainDeviation& deviation, const Quantity* q, double force,
                  double thickness) {
    const StrainPoint own = own_point(deviation.contact, false);
    for (const StrainPair& pair : deviation.pairs)
        if (pair.point.level == 0 && !pair.point.rolled && pair.point.normal_force == force &&
            pair.point.thickness == thickness &&
            pair.point.tangential_ratio == own.tangential_ratio)
            return 100 * pair.deviation(q).value_or(std::numeric_limits<double>::quiet_NaN());
    return std::numeric_limits<double>::quiet_NaN();
}

report::Figure strain_map(const StrainDeviation& deviation, const Quantity* q) {
    const StrainPoint own = own_point(deviation.contact, false);
    report::Figure figure{
        .id = "map_" + ratio_key(*q),
        .title = fmt::format("{}: {}", q->symbol, q->name),
        .caption = fmt::format(
            "Linear law over finite strains ({}), minus 1, in percent, at f_T = {}; lines at 1, 2, "
            "5 % and so on. The point is the case.",
            name_of(deviation.contact.law()), report::significant(own.tangential_ratio, 3)),
        .x = force_axis,
        .y = {"thickness b [mm]", true}};
    report::ContourMap map{.label = "deviation [%]",
                           .x = places(deviation, &StrainPoint::normal_force),
                           .y = places(deviation, &StrainPoint::thickness),
                           .values = {},
                           .levels = strain_levels};
    for (const double thickness : map.y)
        for (const double force : map.x)
            map.values.push_back(percent_at(deviation, q, force, thickness));
    for (double& thickness : map.y) thickness *= 1e3;
    figure.map = std::move(map);
    figure.curves.push_back({.name = "this case",
                             .x = {own.normal_force},
                             .y = {1e3 * own.thickness},
                             .kind = report::Curve::Kind::points});
    return figure;
}

report::Curve deviation_curve(const StrainDeviation& deviation, const Quantity* q,
                              StrainAxis axis) {
    report::Curve curve{.name = q->symbol, .kind = report::Curve::Kind::line_and_points};
    for (const DeviationPoint& p : deviation_along(deviation, q, axis)) {
        curve.add(p.at, 100 * p.deviation);
        curve.y_error.push_back(100 * p.error);
    }
    return curve;
}

report::Figure curves_along(const StrainDeviation& deviation, StrainAxis axis,
                            const std::string& id, const std::string& title,
                            const report::FigureAxis& x) {
    report::Figure figure{.id = id,
                          .title = title,
                          .caption =
                              "Linear law over finite strains, minus 1; bars: numerical "
                              "error, taken from the case's own point.",
                          .x = x,
                          .y = {"deviation [%]"}};
    for (const Quantity* q : strain_quantities) {
        // Without friction neither depends on F_T.
        const bool pressed = q == &quantities::indentation || q == &quantities::contact_radius ||
                             q == &quantities::peak_pressure;
        if (pressed && axis == StrainAxis::tangential_ratio) continue;
        report::Curve curve = deviation_curve(deviation, q, axis);
        if (curve.x.size() > 1) figure.curves.push_back(std::move(curve));
    }
    return figure;
}

}  // namespace

std::vector<report::Figure> strain_maps(const StrainDeviation& deviation) {
    std::vector<report::Figure> figures;
    for (const Quantity* q : strain_quantities)
        // What was rolled lies on the case's thickness alone.
        if (!is_rolled(q) && !deviation_along(deviation, q, StrainAxis::thickness).empty())
            figures.push_back(strain_map(deviation, q));
    return figures;
}

std::vector<report::Figure> strain_curves(const StrainDeviation& deviation) {
    std::vector<report::Figure> figures{
        curves_along(deviation, StrainAxis::normal_force, "over_force",
                     "Deviation over the normal force", force_axis),
        curves_along(deviation, StrainAxis::tangential_ratio, "over_tangential_force",
                     "Deviation over the tangential force", {"f_T = F_T/(mu F_N) [-]"})};
    std::erase_if(figures, [](const report::Figure& f) { return f.curves.empty(); });
    return figures;
}

}  // namespace tricontact::comparisons
