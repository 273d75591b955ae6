#pragma once

#include <complex>
#include <vector>

namespace tricontact::contact {

/// Shear relaxation of the substrate as a generalised Maxwell solid (Prony series):
///   G(t) = G_inf [1 + sum g_i exp(-t/tau_i)],  G_inf the shear modulus of the case's `substrate`.
/// One branch is the standard solid: a spring G1 = G_inf parallel to a Maxwell element G2, eta,
/// with g = G2/G1, tau = eta/G2. Christensen (1982), Theory of Viscoelasticity, ch. 1.
struct Relaxation {
    struct Branch {
        double ratio = 0;  ///< g_i = G_i/G_inf [-], > 0
        double time = 0;   ///< tau_i [s], > 0
    };
    /// What the bulk modulus does: relaxes like the shear modulus (Poisson's ratio is constant in
    /// time), or stays what it is for the relaxed substrate. At nu = 1/2 there is no difference.
    enum class Bulk { proportional, elastic };

    std::vector<Branch> branches;
    Bulk bulk = Bulk::proportional;

    /// G(0)/G_inf.
    double instantaneous_ratio() const;
    /// (G' + i G'')/G_inf at the angular frequency omega [rad/s].
    std::complex<double> dynamic_ratio(double omega) const;
};

/// Throws InputError unless every ratio and time is positive and finite.
void check(const Relaxation& relaxation);

/// One step of duration dt [s] in which the strain changes linearly, exact for that (Taylor, Pister
/// and Goudreau 1970; Simo and Hughes 1998, eq. 10.3.12): the strain-like variable h_i of a branch,
/// whose share of the traction over the relaxed stiffness is h_i, becomes
///   h_i <- decay_i h_i + g_i mean_i (u_new - u_old),   mean_i = (1 - exp(-dt/tau_i)) tau_i/dt.
/// dt = 0: no time to relax (mean 1); dt infinite: all is relaxed (decay and mean 0).
struct RelaxationStep {
    RelaxationStep(const Relaxation& relaxation, double duration);

    std::vector<double> decay, gain;  ///< exp(-dt/tau_i); g_i mean_i
    double stiffness = 1;             ///< 1 + sum g_i mean_i: of the step, over the relaxed one
};

}  // namespace tricontact::contact
