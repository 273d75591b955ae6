#pragma once

namespace tricontact::contact {

/// How Coulomb's coefficient falls with the way s that a point has slipped since it last stuck,
///   mu(s) = mu - drop (1 - f(s)),   f = max(0, 1 - s/D_c) or exp(-s/D_c):
/// slip-weakening, Ida (1972), Palmer and Rice (1973), Andrews (1976). What sticks again is healed.
struct FrictionWeakening {
    enum class Law { linear, exponential };

    Law law = Law::linear;
    double drop = 0;    ///< mu - mu_k [-]
    double length = 0;  ///< D_c [m]

    /// f(s) [-], and its integral from 0 to s [m].
    double left(double way) const;
    double integral(double way) const;
};

/// Yield of a layer between the surfaces: it flows, and carries tau_c = stress + hardening u, by
/// the way u that it has flowed at a place of the substrate. Hou, Kalousek and Magel (1997);
/// Meierhofer et al. (2014).
struct InterfaceYield {
    double stress = 0;     ///< tau_c0 [Pa]
    double hardening = 0;  ///< k_tau [Pa/m]; below 0 it softens
};

}  // namespace tricontact::contact
