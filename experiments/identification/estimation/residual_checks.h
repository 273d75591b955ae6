#pragma once

#include <vector>

#include "experiments/identification/estimation/best_sum_of_squares.h"
#include "experiments/identification/estimation/identification.h"

namespace tricontact::experiments {

/// Fills `residuals`, `outlying`, `widening` and `possible_widening` of what was found at `x`,
/// whose `logarithmic` is that of independent errors, and widens it: where residuals have a
/// pattern, errors of neighbouring rows are taken to be correlated as the residuals are.
void check_residuals(const IdentificationTask& task, const BestSumOfSquares& squares,
                     const std::vector<double>& x, Identification& found);

/// Below this a lack of fit or an outlying row is not left to chance.
inline constexpr double rare_chance = .01;

}  // namespace tricontact::experiments
