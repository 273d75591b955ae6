#include "walking/machine/motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tricontact::walking {

using std::numbers::sqrt2;

double spring_force(const Machine& machine, const Motion& motion) {
    const Kappas& k = machine.kappas;
    return k.kappa1 * (motion.base - motion.x + k.kappa8 * motion.phi);
}

SpotForce spot_force(const Machine& machine, const Spot& spot, const SpotDeflection& deflection) {
    const double kappa2 = machine.kappas.kappa2;
    const auto& [normal, tangential, flank] = deflection;
    if (machine.model == Machine::Model::prism)  // two contacts a side: eqs. 5.2.20, 5.2.21
        return {sqrt2 * (kappa2 * normal + flank), 2 * tangential};
    return {spot.stiffness * kappa2 * normal, spot.stiffness * tangential};
}

Acceleration acceleration(const Machine& machine, std::span<const Spot> springs,
                          const Motion& motion) {
    const auto& [kappa1, kappa2, kappa3, kappa4, kappa5, kappa6, kappa7, kappa8] = machine.kappas;
    const auto& [moment_amplitude, force_amplitude, frequency] = machine.excitation;
    const double phi = motion.phi, pull = spring_force(machine, motion);
    const double rotation = phi / kappa3;
    double x = pull, z = kappa4, moment = -pull * (kappa3 * kappa3 * kappa8 + phi);
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const auto [normal, tangential] = spot_force(machine, springs[i], motion.spots[i]);
        x -= tangential;
        z -= normal;
        moment += kappa3 * normal * (normal_lever(springs[i], rotation) + phi) -
                  tangential * (kappa3 * kappa3 - springs[i].position * phi);
    }
    if (frequency > 0) {
        const double phase = std::sin(frequency * motion.time);
        z += force_amplitude * phase;
        moment += kappa3 * moment_amplitude * phase;
    }
    return {x, machine.mechanisms.vertical ? z : 0,
            machine.mechanisms.rotation ? moment / kappa7 : 0};
}

Motion between(const Motion& a, const Motion& b, double share) {
    Motion motion = a;
    const auto mix = [share](double& from, double to) { from += share * (to - from); };
    for (const auto member : {&Motion::time, &Motion::base, &Motion::x, &Motion::z, &Motion::phi,
                              &Motion::x_velocity, &Motion::z_velocity, &Motion::phi_velocity})
        mix(motion.*member, b.*member);
    for (std::size_t i = 0; i < a.spots.size(); ++i)
        for (const auto member :
             {&SpotDeflection::normal, &SpotDeflection::tangential, &SpotDeflection::flank})
            mix(motion.spots[i].*member, b.spots[i].*member);
    return motion;
}

double normal_deflection(const Machine& machine, const Spot& spring, const Motion& motion) {
    const double slope = machine.model == Machine::Model::prism ? 1 / sqrt2 : 1;
    return std::max(0., slope * approach(spring, motion.z, motion.phi / machine.kappas.kappa3));
}

Motion motion_at_start(const Machine& machine, const Start& start) {
    const double rest = static_displacement(machine), speed = machine.kappas.kappa6;
    Motion motion{.base = start.base * rest,
                  .x = start.x * rest,
                  .z = start.z * rest,
                  .phi = start.phi * rest,
                  .x_velocity = start.x_velocity * speed,
                  .z_velocity = start.z_velocity * speed,
                  .phi_velocity = start.phi_velocity * speed};
    for (const Spot& spring : springs_of(machine))
        motion.spots.push_back({.normal = normal_deflection(machine, spring, motion)});
    return motion;
}

}  // namespace tricontact::walking
