#pragma once

#include <functional>
#include <vector>

namespace tricontact::statistics {

/// Shares of the variance of a function of independent variables (Sobol' 1993).
struct SobolIndices {
    double mean = 0, variance = 0;
    std::vector<double> first;  ///< of each variable alone
    std::vector<double> total;  ///< of each with all interactions it takes part in
};

/// Functions of points of the unit cube, several at once; NaN where one is not defined.
using SampledFunctions = std::function<std::vector<double>(const std::vector<double>&)>;

/// What samples say of functions of uniform variables.
struct SobolSample {
    std::vector<std::vector<double>> points;  ///< A and B, 2 n_samples points of the unit cube
    std::vector<std::vector<double>> values;  ///< there, one row per point
    std::vector<SobolIndices> indices;        ///< one per function, of the samples that define it
};

/// By n_samples (n_variables + 2) evaluations: matrices A and B of one Sobol' sequence of twice as
/// many variables (GSL), and A with each column of B in turn. First-order indices by Saltelli et
/// al. (2010, Comput. Phys. Commun. 181, 259, table 2, (b)), total ones by Jansen (1999) ((f)).
/// The same on every computer. Throws std::invalid_argument unless n_variables is 1 to 20 and
/// n_samples at least 2; what the functions throw.
SobolSample sobol_indices(const SampledFunctions& functions, int n_variables, int n_samples);

}  // namespace tricontact::statistics
