#pragma once

#include <cstdint>
#include <vector>

#include "statistics/sparse_polynomial.h"

namespace tricontact::statistics {

/// A point of [-1, 1]^n_variables of a sequence whose first n points are spread evenly, for any n,
/// over the Chebyshev measure prod_d dx_d / (pi sqrt(1 - x_d^2)): Sobol's sequence (1967) with the
/// direction numbers of Joe and Kuo (2008) and a fixed digital shift, mapped by x = cos(pi u).
/// Towards the faces of the cube the points become dense, as a polynomial's least squares want them
/// (Cohen, Davenport and Leviatan 2013): nothing is extrapolated there. The same on every computer:
/// coordinates are multiples of 2^-32, by far coarser than the rounding of a cosine.
/// Throws std::invalid_argument unless n_variables is 1 ... most_variables.
std::vector<double> sample_point(std::uint32_t index, int n_variables);

/// The points 0 ... n_points - 1, the coordinates of one after those of the other.
std::vector<double> sample_points(std::uint32_t n_points, int n_variables);

}  // namespace tricontact::statistics
