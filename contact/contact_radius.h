#pragma once

#include <vector>

#include "contact/compliance.h"

namespace tricontact::contact {

/// Contact radius [m] of an about axisymmetric, smooth contact centred at `centre`: the zero of
/// p^2(r^2), a cubic in r^2 fitted by area-weighted least squares to the pressures between 0.5 and
/// 0.9 of the radius that the contact area counts. A pressure that ends like a square root has a
/// smooth p^2, so the estimate resolves fractions of a cell (counting cells is first order only).
double contact_radius(const ContactPoints& points, const std::vector<double>& pressure,
                      const Vector2& centre);

}  // namespace tricontact::contact
