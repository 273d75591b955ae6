#pragma once

#include <string>
#include <vector>

#include "experiments/identification/estimation/identification.h"

namespace tricontact::experiments {

/// A product of powers of parameters that the observations tell, none of which they tell alone.
struct ToldCombination {
    std::vector<std::size_t> parameters;  ///< of the identification
    std::vector<double> exponents;        ///< that of the first is 1
    double standard_error = 0;            ///< of the product, relative
};

/// Relative standard error from which on a parameter is not told: its interval of 95 % spans a
/// factor of 2.7.
inline constexpr double untold_error = 0.25;

/// All of them, best told first; empty where every parameter is told alone, or only one is not.
/// From the principal directions of the linearised likelihood among the parameters (in logarithms)
/// that are not told alone, whatever the others are. Powers of nu or g hold near the best values.
std::vector<ToldCombination> told_combinations(const Identification& found);

/// "E and R are told only in the combination E R^0.50 (standard error 0.4 %), not each alone (E: 80
/// %, R: not at all)."
std::string sentence(const ToldCombination& combination, const Identification& found);

}  // namespace tricontact::experiments
