#pragma once

namespace tricontact::theory {

// A rigid paraboloid pressed with friction on a half-space whose surface the pressure drags
// sideways: it sticks within a radius c and slips outside, c/a staying what it is as the contact
// grows.

/// c/a in (0, 1) at beta/mu > 0, beta = (1 - 2 nu)/(2 - 2 nu) Dundurs' constant of a rigid
/// indenter, for friction that hardly changes the pressure (relative error of the order of beta^2):
/// beta a/(2 c) ln[(a + c)/(a - c)] = mu K(sqrt(1 - c^2/a^2)). Goodman (1962), Spence (1968);
/// Johnson (1985), section 5.4. Throws std::domain_error for other beta/mu.
double spence_stick_ratio(double beta_over_mu);

/// dF/dd over 4 G a without slip, ln(3 - 4 nu)/(1 - 2 nu) for nu in (-1, 1/2): each increment is
/// that of a flat punch that sticks. Mossakovskii (1954), Spence (1968). Without friction it is
/// 1/(1 - nu), its limit at nu = 1/2. Throws std::domain_error for other nu.
double stuck_normal_stiffness_ratio(double poisson);

}  // namespace tricontact::theory
