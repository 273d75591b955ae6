#include "walking/machine/verlet_energy.h"

namespace tricontact::walking {

namespace {

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
    return stored_energy(machine, run_.spots(), run_.motion()).total() -
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
