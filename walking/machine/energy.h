#pragma once

#include <cstdint>
#include <span>

#include "walking/machine/machine.h"
#include "walking/machine/motion.h"
#include "walking/machine/velocity_verlet.h"

namespace tricontact::walking {

/// Energy a machine holds, in units of k_x b^2: kinetic (x'^2 + z'^2 + kappa7/kappa3^2 phi'^2)/2,
/// f_s^2/(2 kappa1) of the spring, that of the springs of the spots, and -kappa4 z. `spots`:
/// springs_of(machine), here and below.
double stored_energy(const Machine& machine, std::span<const Spot> spots, const Motion& motion);

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

/// Advances a velocity Verlet run by so many steps; energy balance of this stretch. Works are mean
/// forces over a step times its increments, which springs obey exactly, being linear. The scheme
/// changes the kinetic energy by the work of the mean forces plus step^2/8 times the change of sum
/// m a^2:
///   M (v1 - v0) = h (f0 + f1)/2,  q1 - q0 = h v0 + h^2 a0/2.
/// With the kinetic energy of the velocities half a step before and after, v- v+ instead of v^2,
/// the balance is therefore exact for steps of any length, stick and slip included. What remains
/// are the steps in which a spot lands or lifts off: the mean of its normal force errs there, by
/// the order of the step's square.
EnergyBalance verlet_balance(VelocityVerlet& run, std::int64_t n_steps);

}  // namespace tricontact::walking
