#include "walking/machine/energy.h"

#include <cmath>

#include "walking/machine/forces.h"

namespace tricontact::walking {

namespace {

// Springs side by side at a spot: a side of the prism has two contacts.
double multiplicity(const Machine& machine, const Spot& spot) {
    return machine.model == Machine::Model::prism ? 2 : spot.stiffness;
}

}  // namespace

StoredEnergy stored_energy(const Machine& machine, std::span<const Spot> spots,
                           const Motion& motion) {
    const Kappas& k = machine.kappas;
    const double pull = spring_force(machine, motion);
    const double rotation = motion.phi_velocity / k.kappa3;
    StoredEnergy energy{
        .kinetic = (motion.x_velocity * motion.x_velocity + motion.z_velocity * motion.z_velocity +
                    k.kappa7 * rotation * rotation) /
                   2,
        .spring = pull * pull / (2 * k.kappa1),
        .gravity = -k.kappa4 * motion.z};
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const auto& [normal, tangential, flank] = motion.spots[i];
        energy.contacts += multiplicity(machine, spots[i]) / 2 *
                           (k.kappa2 * normal * normal + tangential * tangential + flank * flank);
    }
    return energy;
}

WorkingForces working_forces(const Machine& machine, std::span<const Spot> spots,
                             const Motion& motion) {
    const auto& [moment_amplitude, force_amplitude, frequency] = machine.excitation;
    const double phase = frequency > 0 ? std::sin(frequency * motion.time) : 0;
    const double pull = spring_force(machine, motion), kappa3 = machine.kappas.kappa3;
    double lever = -pull;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const auto [normal, tangential] = spot_force(machine, spots[i], motion.spots[i]);
        lever += kappa3 * normal + tangential * spots[i].position;
    }
    return {.base = pull,
            .excitation_force = force_amplitude * phase,
            .excitation_moment = moment_amplitude * phase,
            .geometric_moment = motion.phi / kappa3 * lever};
}

EnergyBalance work(const Machine& machine, const WorkingForces& forces, double base, double z,
                   double phi) {
    const double rotation = phi / machine.kappas.kappa3;
    return {.base = forces.base * base,
            .excitation = forces.excitation_force * z + forces.excitation_moment * rotation,
            .geometric = forces.geometric_moment * rotation};
}

double slip_work(const Machine& machine, const Spot& spot, const SpotDeflection& deflection,
                 double slip, double flank_slip) {
    return multiplicity(machine, spot) *
           (deflection.tangential * slip + deflection.flank * flank_slip);
}

}  // namespace tricontact::walking
