#pragma once

#include <string_view>
#include <vector>

#include "contact/case.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"

namespace tricontact::verification {

/// A body other than paraboloid and sphere.
struct Body {
    std::string_view name;
    contact::Case::Shape shape;
    double exponent;  ///< of a power law
};

inline std::vector<Body> bodies() {
    using enum contact::Case::Shape;
    return {{"Cone", cone, 1},
            {"PowerLaw15", power_law, 1.5},
            {"PowerLaw3", power_law, 3},
            {"PowerLaw4", power_law, 4},
            {"RoundedPunch", rounded_punch, 0},
            {"Ellipsoid", ellipsoid, 0}};
}

/// Largest f that the springs of MDR shake down at w = W/a under a body of revolution, by P(x) and
/// g(x), force and indentation at which the contact has the radius x:
///   1 - [P(W) + 2 E* W (d - g(W))]/F_N, the springs of W < |x| < a over all.
inline double bed_limit(const contact::Case& c, double w) {
    const auto body = c.make_axisymmetric_indenter();
    const double a = contact::half_space_scales(c).contact_radius, x = w * a;
    const double within = w > 0 ? body->pressed_area(x) : 0;
    const double flat = 2 * x * (body->plane_profile(a) - body->plane_profile(x));
    return 1 - (within + flat) / body->pressed_area(a);
}

/// A sphere of `radius` worn flat up to `flat` from its axis, by points: h = (r^2 - flat^2)/2 R.
inline std::vector<contact::ProfileCurve::Point> worn_sphere(double radius, double flat) {
    std::vector<contact::ProfileCurve::Point> points{{0, 0, false}, {flat, 0, true}};
    for (double r = flat + .5e-3; r < 12e-3; r += .5e-3)
        points.push_back({r, (r * r - flat * flat) / (2 * radius), false});
    return points;
}

/// A rigid body on rubber, uncoupled and not rolling; no scale is 1.
inline contact::Case body_case(contact::Case::Shape shape, double exponent) {
    contact::Case c;
    c.indenter.shape = shape;
    c.indenter.exponent = exponent;
    c.indenter.angle = .15;
    c.indenter.radius = .04;
    c.indenter.radius_y = .1;
    c.indenter.flat_radius = .003;
    c.indenter.profile = worn_sphere(c.indenter.radius, .002);
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .3;
    c.of<contact::Cells>().per_radius = 22.5;
    return c;
}

}  // namespace tricontact::verification
