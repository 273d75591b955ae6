#include "comparisons/finite_strain/strain_deviation.h"

#include <algorithm>
#include <cmath>

namespace tricontact::comparisons {

namespace {

double abscissa(const StrainPoint& point, StrainAxis axis) {
    switch (axis) {
        case StrainAxis::normal_force:
            return point.normal_force;
        case StrainAxis::thickness:
            return point.thickness;
        case StrainAxis::tangential_ratio:
            break;
    }
    return point.tangential_ratio;
}

/// Whether a point differs from the case's own in nothing but that.
bool lies_on(const StrainPoint& point, const StrainPoint& own, StrainAxis axis) {
    using enum StrainAxis;
    return point.level == own.level && point.rolled == own.rolled &&
           (axis == normal_force || point.normal_force == own.normal_force) &&
           (axis == thickness || point.thickness == own.thickness) &&
           (axis == tangential_ratio || point.tangential_ratio == own.tangential_ratio);
}

const StrainPair* find_pair(const StrainDeviation& deviation, const StrainPoint& point) {
    const auto found = std::ranges::find(deviation.pairs, point, &StrainPair::point);
    return found == deviation.pairs.end() ? nullptr : &*found;
}

}  // namespace

StrainDeviation strain_deviation(const StrainContact& contact,
                                 const std::vector<std::optional<Results>>& results) {
    StrainDeviation deviation{.contact = contact, .pairs = {}, .errors = {}};
    const auto points = strain_points(contact);
    for (std::size_t i = 0; i < points.size(); ++i)
        deviation.pairs.push_back(
            {points[i], strain_values(results.at(2 * i)), strain_values(results.at(2 * i + 1))});
    deviation.n_failed_runs = static_cast<std::size_t>(
        std::ranges::count_if(results, [](const auto& one) { return !one; }));
    for (const Quantity* q : strain_quantities) {
        StrainPoint point = own_point(contact, is_rolled(q));
        const StrainPair* own = find_pair(deviation, point);
        point.level = 1;
        const StrainPair* finer = find_pair(deviation, point);
        const auto one = own ? own->deviation(q) : std::nullopt,
                   other = finer ? finer->deviation(q) : std::nullopt;
        if (one && other) deviation.errors[q] = std::abs(*one - *other);
    }
    return deviation;
}

std::vector<DeviationPoint> deviation_along(const StrainDeviation& deviation, const Quantity* q,
                                            StrainAxis axis) {
    const double* error = found(deviation.errors, q);
    std::vector<DeviationPoint> points;
    for (const StrainPair& pair : deviation.pairs) {
        if (!lies_on(pair.point, own_point(deviation.contact, is_rolled(q)), axis)) continue;
        if (const auto value = pair.deviation(q))
            points.push_back({abscissa(pair.point, axis), *value, error ? *error : 0});
    }
    std::ranges::sort(points, {}, &DeviationPoint::at);
    return points;
}

std::vector<StrainRow> strain_rows(const StrainDeviation& deviation) {
    std::vector<StrainRow> rows;
    for (const Quantity* q : strain_quantities) {
        const StrainPair* own = find_pair(deviation, own_point(deviation.contact, is_rolled(q)));
        const auto value = own ? own->deviation(q) : std::nullopt;
        if (!value) continue;
        StrainRow& row =
            rows.emplace_back(StrainRow{q, *found(own->linear, q), *found(own->finite, q), *value});
        if (const double* error = found(deviation.errors, q)) row.error = *error;
        const auto points = deviation_along(deviation, q, StrainAxis::normal_force);
        row.largest_force = points.back().at;
        std::ranges::transform(strain_tolerances, row.forces.begin(), [&](double tolerance) {
            return strain_threshold(points, tolerance, true);
        });
    }
    return rows;
}

}  // namespace tricontact::comparisons
