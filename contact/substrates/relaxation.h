#pragma once

#include <cmath>
#include <complex>
#include <vector>

namespace tricontact::contact {

/// Shear relaxation of a body, usually the substrate, as a generalised Maxwell solid (Prony
/// series):
///   G(t) = G_inf [1 + sum g_i exp(-t/tau_i)],  G_inf the shear modulus that the case gives the
///   body.
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
    /// Of two bodies that relax, both by the same g_i and tau_i.
    enum class Body { substrate, indenter, both };

    std::vector<Branch> branches;
    Bulk bulk = Bulk::proportional;
    Body body = Body::substrate;

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

/// Creep of a relaxing spring beside an elastic one: with the stiffnesses a and G(t)/G_inf, unit
/// load displaces by
///   J(t) = relaxed - sum compliance_i exp(-t/time_i),
/// a generalised Kelvin solid with as many branches as the relaxation, each slower than one of
/// them. Tschoegl (1989), The Phenomenological Theory of Linear Viscoelastic Behavior, ch. 4.
struct Retardation {
    struct Branch {
        double compliance = 0;  ///< [-], > 0
        double time = 0;        ///< [s]
    };

    /// `spring` [-]: a >= 0. Throws InputError for a relaxation that check() refuses.
    Retardation(const Relaxation& relaxation, double spring);

    double relaxed = 1;  ///< 1/(a + 1)
    std::vector<Branch> branches;
};

/// Integrals over a step of duration x relaxation times of a variable that starts at e, is driven
/// by w in all at a constant rate, and decays:
///   e(s) = e exp(-s x) + w mean(s x) s,   0 <= s <= 1,   mean(x) = (1 - exp(-x))/x.
/// What a dashpot dissipates is <e, e> ee + 2 <e, w> ew + <w, w> ww; the variable's mean is
/// e mean + w drift.
/// All to rounding of 1.
struct StepIntegrals {
    explicit StepIntegrals(double x) {
        const double once = -std::expm1(-x);
        mean = x == 0 ? 1 : std::isinf(x) ? 0 : once / x;
        drift = drift_of(x);
        ee = -std::expm1(-2 * x) / 2;
        ew = once * mean / 2;
        ww = drift - mean * mean / 2;
    }
    double ee, ew, ww, mean, drift;

  private:
    // (1 - mean)/x = (x - 1 + exp(-x))/x^2, 1/2 at x = 0. The series leaves less than rounding
    // below 0.05, the direct form loses three digits there and fewer beyond.
    static double drift_of(double x) {
        constexpr double series_below = 0.05;
        if (std::isinf(x)) return 0;
        if (x >= series_below) return (x + std::expm1(-x)) / (x * x);
        double term = 0.5, sum = 0;
        for (int n = 3; n <= 11; ++n) {
            sum += term;
            term *= -x / n;
        }
        return sum;
    }
};

}  // namespace tricontact::contact
