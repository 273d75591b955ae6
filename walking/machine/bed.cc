#include "walking/machine/bed.h"

#include <cmath>

namespace tricontact::walking {

double resting_indentation(double load) {
    return 1.5 * load;
}

std::vector<Spot> bed_springs(const Bed& bed, const Spot& spot, double load) {
    const double depth = resting_indentation(load);
    const double contact_radius = std::sqrt(bed.radius * depth);
    const double spacing = 2 * bed.width / bed.springs;  // over the contact radius
    std::vector<Spot> springs;
    for (int i = 0; i < bed.springs; ++i) {
        const double place = (i + 0.5) * spacing - bed.width;
        springs.push_back({.position = spot.position,
                           .height = spot.height + place * place * depth,  // s^2/R
                           .stiffness = spot.stiffness * spacing / 2,
                           .offset = place * contact_radius,
                           .tip_radius = bed.radius});
    }
    return springs;
}

}  // namespace tricontact::walking
