#pragma once

#include <vector>

#include "theory/layer/layer_compliance.h"

namespace tricontact::theory {

// Frictionless contact of a rigid cylinder, profile x^2/(2R), with an elastic layer on a rigid
// plane, plane strain: all loads are per length of the cylinder. Exact but for rounding.
//   ∫_-a^a p(t) K(x - t) dt = d - x^2/(2R),  K(s) = (1/pi) ∫_0^inf C33(k) cos(k s) dk, p(+-a) = 0.
// K is -ln|s| 2/(pi E*), which Chebyshev's polynomials diagonalise under the weight
// 1/sqrt(a^2 - t^2), plus a smooth kernel; collocation at Chebyshev's points, more of them until
// nothing moves. The half-space has no finite d; on the layer d is the cylinder's approach to the
// rigid base. Limits: Hertz' line contact for b/a -> infinity (Johnson 1985, section 4.2c), a bed
// of springs for thin layers (compressible, or on a frictionless base).
// Range: 1e-12 b <= a <= 32 b, every nu in (-1, 1/2], both bases.

/// What is prescribed of the contact.
struct LineControl {
    enum class Kind { load, indentation, half_width };
    Kind kind = Kind::load;
    double value = 0;  ///< F/L [N/m], d [m] or a [m], > 0
};

/// One state of contact, SI units.
struct LineContact {
    double half_width;                    ///< a [m]
    double indentation;                   ///< d [m] at the contact centre
    double load;                          ///< F/L [N/m]
    double stiffness;                     ///< of the load over d [Pa]: that of a flat punch
    double centre_pressure;               ///< p(0) [Pa], the largest
    std::vector<double> edge_load_modes;  ///< of p sqrt(a^2 - x^2) over cos(2m acos(x/a)) [N/m]

    /// Pressure [Pa] at x [m], zero outside; to 1e-10 of the mean pressure.
    double pressure(double x) const;
    /// Load F/L [N/m] carried beyond |x| >= 0 [m], on both sides. With x = W its share of the load
    /// is (1/F_N) ∫ min p dA of a contact rolled over +-W: the limit of shakedown.
    double load_beyond(double x) const;
};

/// Contact of a cylinder of the radius R [m]. Throws contact::InputError for values out of range,
/// contact::NotConverged if more points keep changing the result.
LineContact solve_line_contact(const ElasticLayer& layer, double radius,
                               const LineControl& control);

}  // namespace tricontact::theory
