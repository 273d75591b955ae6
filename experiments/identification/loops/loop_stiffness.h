#pragma once

#include <optional>
#include <span>
#include <vector>

#include "experiments/identification/loops/loop_fit.h"

namespace tricontact::experiments {

/// A stiffness [N/m] that rows of a loop show, whatever law they follow: a weighted sum of their
/// forces, so that errors of these go through it and a computed loop is read in the same way.
using RowWeights = std::vector<double>;

/// Part of the way of a branch over which a loop is about as stiff as it gets.
inline constexpr double stiff_part = .3;

/// Behind the reversals: slope of the straight line through the rows of the first `part` of the way
/// of each branch, mean of those with three rows there; empty: neither has.
std::optional<RowWeights> initial_stiffness(const LoopRows& rows, double part);

/// From one reversal to the other: rows of the last twentieth of the way of each branch, one at
/// least.
RowWeights secant_stiffness(const LoopRows& rows);

double weighted(const RowWeights& weights, std::span<const double> values);
/// Standard error by those of the rows.
double weighted_error(const RowWeights& weights, const LoopRows& rows);

}  // namespace tricontact::experiments
