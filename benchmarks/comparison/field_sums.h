#pragma once

#include <cmath>
#include <optional>

#include "benchmarks/comparison/field_norms.h"

namespace tricontact::benchmarks {

/// From the centre of the contact, or along the profile [m].
inline double distance(const UnderstoodMesh& mesh, const SurfacePoint& p) {
    return mesh.result.geometry == Geometry::spatial ? std::hypot(p.x, p.y) : std::abs(p.x);
}

/// p0 of the reference [Pa]; where it is infinite, the pressure that its fields have at the centre.
inline double peak_of(const Reference& reference) {
    const ReferenceValue* p0 = reference.find(quantity_keys::peak_pressure);
    return p0 && std::isfinite(p0->value) ? p0->value : reference.fields->at(0, 0).pressure;
}

/// Sums over the points of a mesh, by their areas.
struct FieldSums {
    const UnderstoodMesh& mesh;
    const ReferenceSamples& samples;
    const Reference& reference;

    /// Root of the mean square over points in a ring, over `scale`.
    template <class Difference>
    std::optional<double> root(double low, double high, double scale_squared,
                               const Difference& difference) const {
        double sum = 0;
        int n = 0;
        const auto& points = mesh.result.points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double r = distance(mesh, points[i]), d = difference(i);
            if (r < low || r > high || !std::isfinite(d)) continue;
            sum += points[i].area * d * d;
            ++n;
        }
        if (n == 0 || !(scale_squared > 0)) return {};
        return std::sqrt(sum / scale_squared);
    }
    template <class Value>
    double integral(double low, double high, const Value& value) const {
        double sum = 0;
        const auto& points = mesh.result.points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double r = distance(mesh, points[i]), v = value(i);
            if (r >= low && r <= high && std::isfinite(v)) sum += points[i].area * v;
        }
        return sum;
    }
};

}  // namespace tricontact::benchmarks
