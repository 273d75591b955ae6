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

VerletEnergy::VerletEnergy(const VelocityVerlet& run)
    : run_(run),
      start_energy_(stored_now()),
      before_(run.motion()),
      forces_before_(working_forces(run.machine(), run.spots(), before_)) {}

double VerletEnergy::stored_now() const {
    const Machine& machine = run_.machine();
    const auto [x, z, phi] = acceleration(machine, run_.spots(), run_.motion());
    const double rotation = phi / machine.kappas.kappa3;
    const double squares = x * x + z * z + machine.kappas.kappa7 * rotation * rotation;
    return stored_energy(machine, run_.spots(), run_.motion()) -
           run_.step() * run_.step() / 8 * squares;
}

void VerletEnergy::add_step() {
    const Machine& machine = run_.machine();
    const Motion& now = run_.motion();
    const WorkingForces forces = working_forces(machine, run_.spots(), now);
    const EnergyBalance done = work(machine, mean(forces_before_, forces), now.base - before_.base,
                                    now.z - before_.z, now.phi - before_.phi);
    works_.base += done.base;
    works_.excitation += done.excitation;
    works_.geometric += done.geometric;
    for (std::size_t i = 0; i < run_.spots().size(); ++i) {
        const SpotDeflection &a = before_.spots[i], &b = now.spots[i];
        const SpotDeflection middle{.tangential = mean(a.tangential, b.tangential),
                                    .flank = mean(a.flank, b.flank)};
        const SpotStep& step = run_.spot_steps()[i];
        works_.dissipation +=
            slip_work(machine, run_.spots()[i], middle, step.slip, step.flank_slip);
    }
    before_ = now;
    forces_before_ = forces;
}

EnergyBalance VerletEnergy::balance() const {
    EnergyBalance balance = works_;
    balance.stored = stored_now() - start_energy_;
    return balance;
}

}  // namespace tricontact::walking
