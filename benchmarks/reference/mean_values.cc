#include <array>
#include <cmath>

#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

SurfaceValues mean_values(const ReferenceFields& fields, double x, double y, double area) {
    static constexpr std::array points{-.8611363115940526, -.3399810435848563, .3399810435848563,
                                       .8611363115940526};
    static constexpr std::array weights{.3478548451374538, .6521451548625461, .6521451548625461,
                                        .3478548451374538};
    const double half = std::sqrt(area) / 2;
    SurfaceValues mean;
    for (std::size_t j = 0; j < points.size(); ++j)
        for (std::size_t i = 0; i < points.size(); ++i) {
            const SurfaceValues v = fields.at(x + half * points[i], y + half * points[j]);
            const double w = weights[i] * weights[j] / 4;
            mean.pressure += w * v.pressure;
            mean.traction_x += w * v.traction_x;
            mean.traction_y += w * v.traction_y;
            mean.displacement_x += w * v.displacement_x;
            mean.displacement_y += w * v.displacement_y;
            mean.displacement_z += w * v.displacement_z;
        }
    return mean;
}

}  // namespace tricontact::benchmarks
