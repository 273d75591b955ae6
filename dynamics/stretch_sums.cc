#include "dynamics/stretch_sums.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tricontact::dynamics {

void StretchSums::add(const StretchSums& other) {
    if (steps == 0) spots.resize(other.spots.size());
    if (spots.size() != other.spots.size())
        throw std::invalid_argument("stretches with different numbers of spots");
    steps += other.steps;
    spring_force += other.spring_force;
    kinetic_energy += other.kinetic_energy;
    z_min = std::min(z_min, other.z_min);
    z_max = std::max(z_max, other.z_max);
    phi_min = std::min(phi_min, other.phi_min);
    phi_max = std::max(phi_max, other.phi_max);
    for (std::size_t i = 0; i < spots.size(); ++i) {
        SpotSums& spot = spots[i];
        const SpotSums& more = other.spots[i];
        spot.sticking += more.sticking;
        spot.velocity += more.velocity;
        spot.velocity_squared += more.velocity_squared;
        spot.normal += more.normal;
        spot.normal_squared += more.normal_squared;
        spot.normal_velocity += more.normal_velocity;
    }
}

double correlation(const SpotSums& spot, std::int64_t steps) {
    const double n = static_cast<double>(steps);
    const double covariance = spot.normal_velocity - spot.normal * spot.velocity / n;
    const double normal = spot.normal_squared - spot.normal * spot.normal / n;
    const double velocity = spot.velocity_squared - spot.velocity * spot.velocity / n;
    // Below the rounding of the sums nothing varies.
    constexpr double rounding = 1e-12;
    if (!(normal > rounding * spot.normal_squared) ||
        !(velocity > rounding * spot.velocity_squared))
        return std::numeric_limits<double>::quiet_NaN();
    return covariance / std::sqrt(normal * velocity);
}

}  // namespace tricontact::dynamics
