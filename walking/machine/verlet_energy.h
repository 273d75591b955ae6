#pragma once

#include "walking/machine/energy.h"
#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking {

/// Energy balance of a stretch of a velocity Verlet run. Works are mean forces over a step times
/// its increments, which springs obey exactly, being linear. The scheme changes the kinetic energy
/// by the work of the mean forces plus step^2/8 times the change of sum m a^2:
///   M (v1 - v0) = h (f0 + f1)/2,  q1 - q0 = h v0 + h^2 a0/2.
/// With the kinetic energy of the velocities half a step before and after, v- v+ instead of v^2,
/// the balance is therefore exact for steps of any length, stick and slip included. What remains
/// are the steps in which a spot lands or lifts off: the mean of its normal force errs there, by
/// the order of the step's square.
class VerletEnergy {
  public:
    /// The stretch begins where `run` is now.
    explicit VerletEnergy(const VelocityVerlet& run);

    /// After each step of the run.
    void add_step();

    EnergyBalance balance() const;

  private:
    double stored_now() const;

    const VelocityVerlet& run_;
    double start_energy_;
    Motion before_;
    WorkingForces forces_before_;
    EnergyBalance works_;
};

}  // namespace tricontact::walking
