#include "fem/case/conforming_friction.h"

#include <algorithm>
#include <vector>

namespace tricontact::fem {

// A point that slips has |t| = mu p with q = p cos - t sin: mu q/(cos -+ mu sin), the sign that of
// t sin. Bounds of the present p would follow t by mu tan a step, and leave for mu tan > 1.
void ConformingFriction::bounds_beside(const Points& points, std::span<const double> traction,
                                       std::span<double> bound) const {
    const auto angle_at = [&](std::size_t i) {
        // A single value without a place is that of the lowest point.
        return points.x.empty() ? 0 : points.x[i] / radius_;
    };
    std::vector<double> pressure(bound.size(), 0.);
    for (std::size_t i = 0; i < bound.size(); ++i) {
        const double along_z = points.pressure[i], t = traction.empty() ? 0 : traction[i];
        if (along_z > 0) pressure[i] = std::max(0., radial_pressure(along_z, t, angle_at(i)));
    }
    Points radial = points;
    radial.pressure = pressure;
    law_->bounds(radial, bound);
    for (std::size_t i = 0; i < bound.size() && !traction.empty() && !points.x.empty(); ++i) {
        if (!(pressure[i] > 0) || traction[i] == 0) continue;
        const double ratio = bound[i] / pressure[i],
                     sine = std::copysign(std::sin(angle_at(i)), traction[i] * points.x[i]),
                     divisor = std::cos(angle_at(i)) - ratio * sine;
        // Else it jams: it carries whatever sticking asks for.
        if (divisor > 0) bound[i] = ratio * points.pressure[i] / divisor;
    }
}

}  // namespace tricontact::fem
