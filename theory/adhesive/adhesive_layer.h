#pragma once

#include "contact/bodies/indenter.h"
#include "theory/adhesive/adhesive_curve.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::theory {

/// Contacts of a rigid body of revolution on an elastic layer over a rigid plane, by the integral
/// equation of LayerEquation; `body` shall outlive them.
AdhesiveCurve::Family layer_contacts(const ElasticLayer& layer,
                                     const contact::AxisymmetricIndenter& body);

/// Short-ranged adhesion of a rigid body of revolution on an elastic layer over a rigid plane,
/// exact but for rounding: the punch of the integral equation of LayerEquation gives S(a) and e(a).
/// `body` shall outlive the curve. Contacts of a/b up to largest_radius_over_thickness.
AdhesiveCurve layer_curve(const ElasticLayer& layer, const contact::AxisymmetricIndenter& body,
                          double work);

/// A state of a paraboloid on a layer that is much thinner than the contact is wide.
struct ThinLayerContact {
    double indentation;  ///< d [m]
    double force;        ///< F [N]
};

/// Of a layer that can be compressed: springs p = M u/b with M = E (1 - nu)/((1 + nu) (1 - 2 nu)),
/// whose energy per area at the edge, M l^2/(2 b), is w:
///   d = a^2/(2 R) - l,   F = pi M a^2/b (a^2/(4 R) - l),   l = sqrt(2 w b/M);
/// it pulls off at 2 pi w R.
ThinLayerContact thin_compressible_layer(const ElasticLayer& layer, double radius, double work,
                                         double contact_radius);

/// Of an incompressible layer that is bonded, and on which the body glides: the volume that is
/// displaced flows along, b^3/(3 G) laplace(p) = -(d - r^2/(2 R)), p(a) = 0, and the energy per
/// area at the edge, b^3/(6 G) p'(a)^2, is w:
///   d = a^2/(4 R) - 2/a l^2,   F = 3 pi G/(8 b^3) a^4 (d - a^2/(6 R)),   l^2 = sqrt(2 w b^3/(3
///   G));
/// it pulls off at 3 pi w R.
ThinLayerContact thin_incompressible_layer(const ElasticLayer& layer, double radius, double work,
                                           double contact_radius);

}  // namespace tricontact::theory
