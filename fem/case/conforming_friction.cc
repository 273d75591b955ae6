#include "fem/case/conforming_friction.h"

#include <algorithm>
#include <vector>

namespace tricontact::fem {

void ConformingFriction::bounds_beside(const Points& points, std::span<const double> traction,
                                       std::span<double> bound) const {
    std::vector<double> pressure(bound.size(), 0.);
    for (std::size_t i = 0; i < bound.size(); ++i) {
        // A single value without a place is that of the lowest point.
        const double angle = points.x.empty() ? 0 : points.x[i] / radius_;
        const double along_z = points.pressure[i], t = traction.empty() ? 0 : traction[i];
        if (along_z > 0) pressure[i] = std::max(0., radial_pressure(along_z, t, angle));
    }
    Points radial = points;
    radial.pressure = pressure;
    law_->bounds(radial, bound);
}

}  // namespace tricontact::fem
