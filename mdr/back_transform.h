#pragma once

#include <span>
#include <vector>

namespace tricontact::mdr {

/// Traction [Pa] at the radius r >= 0 [m] of the axisymmetric state whose line load is q:
///   p(r) = -1/pi ∫_r^a q'(x)/sqrt(x^2 - r^2) dx, Popov and Hess (2015), eq. 3.37,
/// for an even q [N/m] given at the increasing `positions` [m], the first of them 0, linear in
/// between, zero beyond the last. Each linear piece is integrated exactly (acosh); in the first
/// one q is even, hence taken as a parabola without slope at 0, which keeps p(0) finite.
/// Throws std::domain_error for fewer than two positions or unequal lengths.
double back_transform(std::span<const double> positions, std::span<const double> line_load,
                      double r);

/// The same in two steps, for several loads at one radius: weights of the slopes of the pieces [-],
/// one fewer than positions, then their sum.
std::vector<double> abel_weights(std::span<const double> positions, double r);
double back_transform(std::span<const double> positions, std::span<const double> line_load,
                      std::span<const double> weights);

}  // namespace tricontact::mdr
