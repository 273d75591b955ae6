#include "dynamics/stretch_recorder.h"

#include <algorithm>
#include <utility>

#include "dynamics/forces.h"

namespace tricontact::dynamics {
namespace {

StretchSums nothing(std::size_t n_spots) {
    StretchSums sums;
    sums.spots.resize(n_spots);
    return sums;
}

/// Wetter (2016), eq. 4.2.16.
double path(const Motion& motion, const SpotDeflection& spot) {
    return motion.x + motion.phi - spot.tangential;
}

}  // namespace

StretchRecorder::StretchRecorder(const Machine& machine, const Motion& start, double step)
    : machine_(machine),
      step_(step),
      rotational_(machine.kappas.kappa7 / (machine.kappas.kappa3 * machine.kappas.kappa3)),
      sums_(nothing(start.spots.size())) {
    for (const SpotDeflection& spot : start.spots)
        paths_.push_back({path(start, spot), path(start, spot), spot.normal});
}

void StretchRecorder::add(const Motion& motion, const std::vector<SpotStep>& spot_steps) {
    ++sums_.steps;
    sums_.spring_force += spring_force(machine_, motion);
    const double x = motion.x_velocity, z = motion.z_velocity, phi = motion.phi_velocity;
    sums_.kinetic_energy += (x * x + z * z + rotational_ * phi * phi) / 2;
    sums_.z_min = std::min(sums_.z_min, motion.z);
    sums_.z_max = std::max(sums_.z_max, motion.z);
    sums_.phi_min = std::min(sums_.phi_min, motion.phi);
    sums_.phi_max = std::max(sums_.phi_max, motion.phi);
    for (std::size_t i = 0; i < paths_.size(); ++i) {
        SpotPath& spot = paths_[i];
        SpotSums& sums = sums_.spots[i];
        const double next = path(motion, motion.spots[i]);
        const double velocity = (next - spot.before) / (2 * step_);
        sums.sticking += spot_steps[i].sticks;
        sums.velocity += velocity;
        sums.velocity_squared += velocity * velocity;
        sums.normal += spot.normal;
        sums.normal_squared += spot.normal * spot.normal;
        sums.normal_velocity += spot.normal * velocity;
        spot = {spot.now, next, motion.spots[i].normal};
    }
}

StretchSums StretchRecorder::take() {
    return std::exchange(sums_, nothing(paths_.size()));
}

}  // namespace tricontact::dynamics
