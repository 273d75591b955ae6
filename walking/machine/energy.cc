#include "walking/machine/energy.h"

#include <cmath>

namespace tricontact::walking {

namespace {

// Springs side by side at a spot: a side of the prism has two contacts.
double multiplicity(const Machine& machine, const Spot& spot) {
    return machine.model == Machine::Model::prism ? 2 : spot.stiffness;
}

double mean(double a, double b) {
    return (a + b) / 2;
}

WorkingForces mean(const WorkingForces& a, const WorkingForces& b) {
    return {.base = mean(a.base, b.base),
            .excitation_force = mean(a.excitation_force, b.excitation_force),
            .excitation_moment = mean(a.excitation_moment, b.excitation_moment),
            .geometric_moment = mean(a.geometric_moment, b.geometric_moment)};
}

/// With the kinetic energy of the velocities half a step before and after.
double stored_by_verlet(const VelocityVerlet& run) {
    const Machine& machine = run.machine();
    const auto [x, z, phi] = acceleration(machine, run.spots(), run.motion());
    const double rotation = phi / machine.kappas.kappa3;
    const double squares = x * x + z * z + machine.kappas.kappa7 * rotation * rotation;
    return stored_energy(machine, run.spots(), run.motion()) -
           run.step() * run.step() / 8 * squares;
}

}  // namespace

double stored_energy(const Machine& machine, std::span<const Spot> spots, const Motion& motion) {
    const Kappas& k = machine.kappas;
    const double pull = spring_force(machine, motion);
    const double rotation = motion.phi_velocity / k.kappa3;
    const double kinetic =
        (motion.x_velocity * motion.x_velocity + motion.z_velocity * motion.z_velocity +
         k.kappa7 * rotation * rotation) /
        2;
    double contacts = 0;
    for (std::size_t i = 0; i < spots.size(); ++i) {
        const auto& [normal, tangential, flank] = motion.spots[i];
        contacts += multiplicity(machine, spots[i]) / 2 *
                    (k.kappa2 * normal * normal + tangential * tangential + flank * flank);
    }
    return kinetic + pull * pull / (2 * k.kappa1) + contacts - k.kappa4 * motion.z;
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

EnergyBalance verlet_balance(VelocityVerlet& run, std::int64_t n_steps) {
    const Machine& machine = run.machine();
    const std::vector<Spot>& spots = run.spots();
    const double stored_before = stored_by_verlet(run);
    EnergyBalance works;
    Motion before = run.motion();
    WorkingForces forces_before = working_forces(machine, spots, before);
    for (std::int64_t step = 0; step < n_steps; ++step) {
        run.advance();
        const Motion& now = run.motion();
        const WorkingForces forces = working_forces(machine, spots, now);
        const EnergyBalance done =
            work(machine, mean(forces_before, forces), now.base - before.base, now.z - before.z,
                 now.phi - before.phi);
        works.base += done.base;
        works.excitation += done.excitation;
        works.geometric += done.geometric;
        for (std::size_t i = 0; i < spots.size(); ++i) {
            const SpotDeflection &a = before.spots[i], &b = now.spots[i];
            const SpotDeflection middle{.tangential = mean(a.tangential, b.tangential),
                                        .flank = mean(a.flank, b.flank)};
            const SpotStep& slip = run.spot_steps()[i];
            works.dissipation += slip_work(machine, spots[i], middle, slip.slip, slip.flank_slip);
        }
        before = now;
        forces_before = forces;
    }
    works.stored = stored_by_verlet(run) - stored_before;
    return works;
}

}  // namespace tricontact::walking
