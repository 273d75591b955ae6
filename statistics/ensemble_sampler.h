#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace tricontact::statistics {

/// Points drawn from a distribution.
struct EnsembleSample {
    std::vector<std::vector<double>> points;
    double acceptance = 0;  ///< share of proposed steps that were taken
    /// Integrated autocorrelation times of the variables [steps of the ensemble]: so many steps are
    /// as good as one independent draw of all walkers.
    std::vector<double> autocorrelation_times;
    int n_steps = 0;  ///< of the ensemble, from which the points are

    /// Independent points that are as good, by the slowest variable.
    double effective_size() const;
};

/// Logarithm of a density, up to a constant; -infinity where it is zero.
using LogDensity = std::function<double(const std::vector<double>&)>;

/// Affine-invariant ensemble of walkers (Goodman and Weare 2010, Comm. App. Math. Comp. Sci. 5,
/// 65), the halves moved in turn by stretches of a = 2 (Foreman-Mackey et al. 2013, PASP 125, 306).
/// The first half of all steps is thrown away; it goes on until the other half is 50 times the
/// longest autocorrelation time of the ensemble's means. `walkers`: where they start, at least
/// twice as many as there are variables, in general position, where the density is positive. The
/// same on every computer but for rounding. Throws std::invalid_argument for other walkers,
/// contact::NotConverged after `most_steps`.
EnsembleSample sample_ensemble(const LogDensity& log_density,
                               std::vector<std::vector<double>> walkers, std::uint64_t seed,
                               int most_steps = 100'000);

}  // namespace tricontact::statistics
