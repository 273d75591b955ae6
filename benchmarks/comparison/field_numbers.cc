#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "benchmarks/comparison/field_sums.h"

namespace tricontact::benchmarks {

namespace {

namespace keys = quantity_keys;
constexpr double centre_share = .3;
constexpr double spike_share = 1. / 3;

/// Weighted least squares p = c0 + c1 r^2 inside `radius`; c0. NaN of fewer than three places.
template <class Pressure>
double fitted_peak(const UnderstoodMesh& mesh, double radius,
                   const std::vector<std::size_t>& left_out, const Pressure& pressure) {
    double s0 = 0, s1 = 0, s2 = 0, b0 = 0, b1 = 0;
    int n = 0;
    const auto& points = mesh.result.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = distance(mesh, points[i]), p = pressure(i);
        if (r > radius || !std::isfinite(p) || std::ranges::find(left_out, i) != left_out.end())
            continue;
        const double q = r * r / (radius * radius);
        ++n;
        s0 += 1;
        s1 += q;
        s2 += q * q;
        b0 += p;
        b1 += q * p;
    }
    const double det = s0 * s2 - s1 * s1;
    if (n < 3 || !(det > 1e-12 * s0 * s2)) return std::numeric_limits<double>::quiet_NaN();
    return (b0 * s2 - b1 * s1) / det;
}

/// The code's pressure over the reference's at the distance r, between the points beside it; NaN
/// beyond them.
template <class Ratio>
double ratio_at(const UnderstoodMesh& mesh, double r, const Ratio& ratio) {
    const auto& points = mesh.result.points;
    double low = -1, high = std::numeric_limits<double>::infinity(), below = 0, above = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double at = distance(mesh, points[i]), q = ratio(i);
        if (!std::isfinite(q)) continue;
        if (at <= r && at > low) low = at, below = q;
        if (at >= r && at < high) high = at, above = q;
    }
    if (low < 0 || !std::isfinite(high)) return std::numeric_limits<double>::quiet_NaN();
    return high > low ? below + (above - below) * (r - low) / (high - low) : below;
}

/// Pressures at places of a contact whose largest is infinite.
void add_pressures_at(std::vector<FieldNumber>& numbers, const UnderstoodMesh& mesh,
                      const ReferenceSamples& samples, const Reference& reference) {
    const auto& points = mesh.result.points;
    if (const ReferenceValue* axis = reference.find(keys::pressure_at_axis)) {
        const auto spike = axis_spike(mesh, reference);
        const double radius = centre_share * reference.contact_radius;
        const double code = fitted_peak(mesh, radius, spike,
                                        [&](std::size_t i) { return points[i].values.pressure; });
        const double own = fitted_peak(mesh, radius, spike,
                                       [&](std::size_t i) { return samples.values[i].pressure; });
        if (std::isfinite(code / own))
            numbers.push_back({keys::pressure_at_axis, code / own * axis->value, axis->value});
    }
    if (const ReferenceValue* near_edge = reference.find(keys::pressure_at_0_9)) {
        const double q = ratio_at(mesh, .9 * reference.contact_radius, [&](std::size_t i) {
            return points[i].values.pressure / samples.values[i].pressure;
        });
        if (std::isfinite(q))
            numbers.push_back({keys::pressure_at_0_9, q * near_edge->value, near_edge->value});
    }
}

}  // namespace

std::vector<std::size_t> axis_spike(const UnderstoodMesh& mesh, const Reference& reference) {
    std::vector<std::size_t> spike;
    const auto& points = mesh.result.points;
    if (mesh.result.geometry == Geometry::plane || points.size() < 8) return spike;
    const double p0 = peak_of(reference), a = reference.contact_radius;
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return distance(mesh, points[i]); });
    // What lies further from the axis shows what is usual there.
    std::vector<double> usual;
    for (const std::size_t i : order) {
        const double r = distance(mesh, points[i]);
        if (r > .25 * a && r < .6 * a) usual.push_back(points[i].values.pressure / p0);
    }
    if (usual.size() < 2) return spike;
    const double high = std::ranges::max(usual), low = std::ranges::min(usual);
    if (high > 1 + spike_share || low < 1 - 2 * spike_share) return spike;  // all of it is rough
    int places = 0;
    double last = -1;
    for (const std::size_t i : order) {
        const double r = distance(mesh, points[i]);
        if (r > last * (1 + 1e-6) + 1e-12) ++places;
        last = r;
        if (places > 3 || r > .25 * a) break;
        if (std::abs(points[i].values.pressure / p0 - 1) > spike_share) spike.push_back(i);
    }
    return spike;
}

std::vector<FieldNumber> field_numbers(const UnderstoodMesh& mesh, const ReferenceSamples& samples,
                                       const Reference& reference) {
    std::vector<FieldNumber> numbers;
    const auto& points = mesh.result.points;
    const auto& ref = samples.values;
    if (points.empty()) return numbers;
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const FieldSums at{mesh, samples, reference};
    const auto moment = [&](bool of_reference, int power) {
        return at.integral(0, everywhere, [&](std::size_t i) {
            const double p = of_reference ? ref[i].pressure : points[i].values.pressure;
            return p * std::pow(distance(mesh, points[i]), power);
        });
    };
    numbers.push_back({keys::normal_force, mesh.field_force.value_or(moment(false, 0)),
                       reference.find(keys::normal_force)->value});
    const double code = moment(false, 2) / moment(false, 0),
                 own = moment(true, 2) / moment(true, 0);
    if (code > 0 && own > 0)
        numbers.push_back({keys::contact_radius, reference.contact_radius * std::sqrt(code / own),
                           reference.contact_radius});
    const double radius = centre_share * reference.contact_radius;
    const ReferenceValue* p0 = reference.find(keys::peak_pressure);
    if (p0 && contact::pressure_falls(reference.c)) {
        const auto spike = axis_spike(mesh, reference);
        const double peak = fitted_peak(mesh, radius, spike,
                                        [&](std::size_t i) { return points[i].values.pressure; });
        const double of_reference =
            fitted_peak(mesh, radius, spike, [&](std::size_t i) { return ref[i].pressure; });
        if (std::isfinite(peak) && std::isfinite(of_reference))
            numbers.push_back({keys::peak_pressure, peak * p0->value / of_reference, p0->value});
    }
    add_pressures_at(numbers, mesh, samples, reference);
    if (reference.has_friction() && std::isfinite(points.front().values.traction_x) &&
        reference.find(keys::tangential_force))
        numbers.push_back(
            {keys::tangential_force,
             at.integral(0, everywhere, [&](std::size_t i) { return points[i].values.traction_x; }),
             reference.find(keys::tangential_force)->value});
    return numbers;
}

}  // namespace tricontact::benchmarks
