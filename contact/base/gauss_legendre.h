#pragma once

#include <vector>

namespace tricontact::contact {

/// Points and weights on (0, 1).
struct QuadratureRule {
    std::vector<double> points, weights;
};

/// Gauss and Legendre's rule of n >= 1 points, exact for polynomials of degree 2n - 1; kept, for
/// its zeros cost more than many an integral.
const QuadratureRule& gauss_legendre(int n);

}  // namespace tricontact::contact
