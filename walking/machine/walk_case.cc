#include "walking/machine/walk_case.h"

#include <algorithm>
#include <numbers>

namespace tricontact::walking {

Motion motion_at_start(const Machine& machine, const Start& start) {
    const double rest = static_displacement(machine), speed = machine.kappas.kappa6;
    Motion motion{.base = start.base * rest,
                  .x = start.x * rest,
                  .z = start.z * rest,
                  .phi = start.phi * rest,
                  .x_velocity = start.x_velocity * speed,
                  .z_velocity = start.z_velocity * speed,
                  .phi_velocity = start.phi_velocity * speed};
    const double slope = machine.model == Machine::Model::prism ? 1 / std::numbers::sqrt2 : 1;
    for (const Spot& spring : springs_of(machine)) {
        const double near = approach(spring, motion.z, motion.phi / machine.kappas.kappa3);
        motion.spots.push_back({.normal = std::max(0., slope * near)});
    }
    return motion;
}

}  // namespace tricontact::walking
