#pragma once

#include <random>

#include "contact/case.h"

namespace tricontact {

using Random = std::mt19937_64;

struct Bounds {
    double low, high;
};

inline double between(Random& random, const Bounds& bounds) {
    return std::uniform_real_distribution<double>(bounds.low, bounds.high)(random);
}

/// A rigid sphere on an incompressible layer, without tangential load. `thickness`: over the
/// contact diameter on the half-space.
inline contact::Case drawn_sphere_on_layer(Random& random, const Bounds& friction,
                                           const Bounds& thickness) {
    contact::Case c;
    c.indenter.radius = between(random, {10e-3, 60e-3});
    c.substrate = {between(random, {1e6, 10e6}), .5};
    c.load.normal_force = between(random, {5, 30});
    c.friction.coefficient = between(random, friction);
    c.load.tangential_force = 0;
    c.layer.thickness =
        2 * contact::half_space_scales(c).contact_radius * between(random, thickness);
    return c;
}

}  // namespace tricontact
