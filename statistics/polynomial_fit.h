#pragma once

#include <cstddef>
#include <span>

#include "statistics/sparse_polynomial.h"

namespace tricontact::statistics {

/// A function known at points of [-1, 1]^n_variables as a sparse polynomial, with its error as a
/// function of the place.
///
/// The leave-one-out residual of a point is its value minus the polynomial (of the same terms) that
/// is fitted to all others. `error_bar` covers the share `coverage` of them: of all points, and of
/// those of any half of the cube or of any of its 2^n_variables sign patterns with enough points,
/// but for what chance may do; and of points in fifths, each against terms, fit and bar from the
/// other four. So it says: a new value, noise included, drawn like the points, lies within the bar
/// of the polynomial with about that probability. It is no bound of the largest error, and says
/// nothing outside the cube.
struct PolynomialFit {
    SparsePolynomial polynomial;
    /// ln of the typical size of the leave-one-out residual: degree 0 to 3.
    SparsePolynomial log_error;
    double error_factor = 0;  ///< bar over exp(log_error)
    /// By how much bars from leave-one-out residuals had to be longer for points that had no part
    /// in the choice of terms, at least 1; it is in `error_factor`. Far above 1: too few points.
    double optimism = 1;
    // Of the absolute leave-one-out residuals; `optimism` is not in them.
    double largest_error = 0;
    double median_error = 0;
    double rms_error = 0;
};

struct PolynomialFitOptions {
    std::size_t most_terms = 800;  ///< besides, half the number of points
    double coverage = 0.95;        ///< of the error bar, in (0, 1)
};

/// Terms grow from the lowest degrees: of the neighbours of the set come those that explain most of
/// the residual (after Gerstner and Griebel 2003; a neighbour is supported by a term of degree
/// lower by one or two in each of its variables, see adaptive_terms.h). Their number is the one of
/// least leave-one-out error with the correction of Chapelle, Vapnik and Bengio (2002), as in
/// Blatman and Sudret (2011). The terms of the result are in lexicographic order; those that
/// rounding made are left out.
///
/// `points`: the coordinates of one after those of the other, best those of `sample_points`; the
/// same arguments give the same result. Throws std::invalid_argument for fewer points than
/// `least_points`, sizes that do not agree, coordinates beyond the cube, numbers that are not
/// finite, and values that are all equal.
PolynomialFit fit_polynomial(std::span<const double> points, std::span<const double> values,
                             int n_variables, const PolynomialFitOptions& options = {});

/// 20, for 19 of 20 leave-one-out residuals to tell a bar of 95 %, or four per variable and four.
std::size_t least_points(int n_variables);

/// Half width of the bar at the point of the table, which must cover `fit.log_error`.
double error_bar(const PolynomialFit& fit, const ChebyshevTable& table);

}  // namespace tricontact::statistics
