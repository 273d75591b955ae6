#pragma once

#include <optional>
#include <string>
#include <utility>

#include "contact/case.h"

namespace tricontact::theory {

/// A law of friction for which a paraboloid that rolls back and forth settles at a shift of one
/// formula,
///   f = f_static(u) - kappa w u,  f = F_T/F_lim, w = W/a, u = U/U_max, all in [0, 1].
/// f_static is the force that shifts by u when applied once. In the method of dimensionality
/// reduction (MDR), whose springs carry b(x), springs of the length 2 W lose their share at the
/// shift u: kappa = 2 a b(0)/F_lim, a constant. In three dimensions it is smaller, and none: see
/// mapped_shakedown.h and mapped_strength.h.
struct RolledLaw {
    const char* name;  ///< "Coulomb's law"
    /// f_static of u_sd for people, what of it stands before and after - kappa w u_sd.
    std::pair<const char*, const char*> form;
    const char* limit_form;  ///< the largest f likewise, k for kappa
    double mdr_mapping;      ///< kappa of MDR
    const char* mdr_text;    ///< "3/2"
    double (*static_force)(double u);
    double (*static_slope)(double u);  ///< d f_static/du
    double (*static_shift)(double f);  ///< u of f_static
    /// u at which the springs beside W carry no more, b(W)/b(0).
    double (*bound)(double w);
    /// Largest f that settles by the formula, f_static - kappa w u at that bound. The one of MDR's
    /// kappa is exact in three dimensions too.
    double (*shakedown_limit)(double w, double kappa);
    double (*amplitude_limit)(double f, double kappa);  ///< its inverse, the largest w
    /// u of f; empty above the limit.
    std::optional<double> (*settled_shift_ratio)(double w, double f, double kappa);
    // From static_shift on all throw std::domain_error for arguments out of [0, 1], or kappa out of
    // (0, mdr_mapping].

    /// kappa of u, w and u in (0, 1]. Ill-conditioned where w u is small; may lie anywhere.
    double mapping_parameter(double w, double f, double u) const;
    bool is_coulomb() const;
    double exact_limit(double w) const { return shakedown_limit(w, mdr_mapping); }
};

/// tau = mu p: f_static = 1 - (1 - u)^(3/2), kappa = 3/2.
extern const RolledLaw coulomb_rolling;
/// tau = tau_0: f_static = (2/pi) [arcsin u + u sqrt(1 - u^2)], kappa = 4/pi.
extern const RolledLaw strength_rolling;

/// That of a case's friction; null if it is neither mu p nor tau_0 alone.
const RolledLaw* rolled_law(const contact::Friction& friction);
/// That of what presumes one, and a rigid interface: `what` ("maps") and `place` of the message.
/// Throws contact::InputError if there is none.
const RolledLaw& require_rolled_law(const contact::Case& c, const std::string& what,
                                    const std::string& place = "friction");

}  // namespace tricontact::theory
