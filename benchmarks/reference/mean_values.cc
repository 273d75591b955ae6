#include <cmath>

#include "benchmarks/reference/reference.h"
#include "contact/base/gauss_legendre.h"

namespace tricontact::benchmarks {

SurfaceValues mean_values(const ReferenceFields& fields, double x, double y, double area) {
    const contact::QuadratureRule& rule = contact::gauss_legendre(4);
    const double side = std::sqrt(area);
    SurfaceValues mean;
    for (std::size_t j = 0; j < rule.points.size(); ++j)
        for (std::size_t i = 0; i < rule.points.size(); ++i) {
            const SurfaceValues v =
                fields.at(x + side * (rule.points[i] - .5), y + side * (rule.points[j] - .5));
            const double w = rule.weights[i] * rule.weights[j];
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
