#include <cmath>
#include <numbers>

#include "benchmarks/comparison/field_norms.h"

namespace tricontact::benchmarks {

namespace {

/// Of a profile: mean pressure over the stretch from low to high [m].
double mean_pressure(const ReferenceFields& fields, bool is_ring, double low, double high) {
    if (!(high > low)) return fields.at(high, 0).pressure;
    if (is_ring)
        return (fields.load_within(high) - fields.load_within(std::max(0., low))) /
               (std::numbers::pi * (high - low) * (high + low));
    const auto load = [&](double x) {
        return std::copysign(fields.load_within(std::abs(x)) / 2, x);
    };
    return (load(high) - load(low)) / (high - low);
}

}  // namespace

ReferenceSamples reference_samples(const UnderstoodMesh& mesh, const Reference& reference) {
    ReferenceSamples samples;
    const ReferenceFields& fields = *reference.fields;
    const double a = reference.contact_radius;
    const auto& points = mesh.result.points;
    samples.values.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfacePoint& p = points[i];
        SurfaceValues v;
        if (mesh.result.geometry != Geometry::spatial) {
            v = fields.at(p.x, 0);
            v.pressure = mean_pressure(fields, mesh.result.geometry == Geometry::axisymmetric,
                                       mesh.low[i], mesh.high[i]);
        } else {
            const double h = std::sqrt(std::max(0., p.area));
            const bool near_edge = std::abs(std::hypot(p.x, p.y) - a) < 3 * h;
            v = near_edge && h > 0 ? mean_values(fields, p.x, p.y, p.area) : fields.at(p.x, p.y);
        }
        samples.values.push_back(v);
        samples.pressure_bars.push_back(fields.bar_at(p.x, p.y).pressure);
    }
    return samples;
}

}  // namespace tricontact::benchmarks
