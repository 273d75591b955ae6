#pragma once

#include <string_view>
#include <vector>

#include "contact/case.h"

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
    c.friction_coefficient = .57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .3;
    c.bem.cells_per_radius = 22.5;
    return c;
}

}  // namespace tricontact::verification
