#pragma once

#include <span>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"

namespace tricontact::walking {

/// Energy a machine holds, in units of k_x b^2.
struct StoredEnergy {
    double kinetic = 0;   ///< (x'^2 + z'^2 + kappa7/kappa3^2 phi'^2)/2
    double spring = 0;    ///< f_s^2/(2 kappa1)
    double contacts = 0;  ///< of the springs of the spots
    double gravity = 0;   ///< -kappa4 z

    double total() const { return kinetic + spring + contacts + gravity; }
};

/// `spots`: springs_of(machine), here and below.
StoredEnergy stored_energy(const Machine& machine, std::span<const Spot> spots,
                           const Motion& motion);

/// Forces whose work changes the stored energy, in units of k_x b and k_x b^2.
struct WorkingForces {
    double base = 0;               ///< f_s, works along x_s
    double excitation_force = 0;   ///< works along z
    double excitation_moment = 0;  ///< works along Phi = phi/kappa3
    /// Moment phi/kappa3 (kappa3 sum N + sum T p - f_s), along Phi. The moments of Wetter (2016),
    /// eq. 4.1.19, have levers of first order in phi, (1 -+ phi), while the springs are deflected
    /// as if the levers were constant: no potential belongs to this part. It is smaller than the
    /// other moments by phi.
    double geometric_moment = 0;
};

WorkingForces working_forces(const Machine& machine, std::span<const Spot> spots,
                             const Motion& motion);

/// Works over a stretch of time and what became of them, in units of k_x b^2.
struct EnergyBalance {
    double base = 0;         ///< work of the base
    double excitation = 0;   ///< of the harmonic load
    double geometric = 0;    ///< of WorkingForces::geometric_moment
    double dissipation = 0;  ///< by slip, >= 0
    double stored = 0;       ///< change of the stored energy

    /// What an integration lost: 0 for exact motions.
    double residual() const { return base + excitation + geometric - dissipation - stored; }
};

/// Works of constant forces over increments, or powers at velocities, of x_s, z and phi.
EnergyBalance work(const Machine& machine, const WorkingForces& forces, double base, double z,
                   double phi);

/// Force of a spot's slider times its slip, in units of k_x b^2; a rate of slip gives a power.
double slip_work(const Machine& machine, const Spot& spot, const SpotDeflection& deflection,
                 double slip, double flank_slip);

}  // namespace tricontact::walking
