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

/// A rigid body on rubber, uncoupled and not rolling; no scale is 1.
inline contact::Case body_case(contact::Case::Shape shape, double exponent) {
    contact::Case c;
    c.indenter.shape = shape;
    c.indenter.exponent = exponent;
    c.indenter.angle = .15;
    c.indenter.radius = .04;
    c.indenter.radius_y = .1;
    c.indenter.flat_radius = .003;
    c.substrate = {5.2e6, .5};
    c.friction_coefficient = .57;
    c.contact.coupling = false;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .3;
    c.bem.cells_per_radius = 22.5;
    return c;
}

}  // namespace tricontact::verification
