#pragma once

#include <vector>

#include "experiments/records/noise_covariance.h"

namespace tricontact::experiments {

/// Noise of evenly sampled values, as seen while nothing moves: neighbours may be correlated, for
/// longer than the values tell (noise_covariance.h).
struct RecordNoise {
    double standard_deviation = 0;
    double resolution = 0;           ///< step of the values
    std::vector<double> covariance;  ///< by the lag; empty: nothing is noisy
    int degrees_of_freedom = 1;      ///< of errors by it
    /// That count as one independent, at least 1.
    double correlated_samples = 1;
    double independent_samples = 3;
    std::vector<PossibleError> possible;  ///< errors of a mean; empty: nothing remembers

    RecordNoise() = default;
    /// From at least three residuals about a trend, of mean zero.
    RecordNoise(const std::vector<double>& residuals, double step);

    /// Standard error of sum_i weights[i] value[i] over successive samples: the root of
    /// sum_ij k_i k_j c(|i - j|). Noise below half a step does not average the steps out: then
    /// resolution^2/12 is added as if all were rounded alike.
    double standard_error(const std::vector<double>& weights) const;
    /// Half width of an interval in standard errors: by the degrees of freedom of independent
    /// samples, and by the errors that are possible where the memory is not known. These are seldom
    /// much larger: what 95 % need is no measure of what 68 % need.
    double coverage_factor(double confidence) const;
    /// Of two samples that are so far apart.
    double covariance_at(std::size_t lag) const;
};

/// Weights of the values y(x) in the polynomial of least squares: its value at a place. Powers that
/// too few different x leave open are omitted.
std::vector<double> weights_of_polynomial_at(double place, const std::vector<double>& x,
                                             int degree);
/// The same for the slope of the straight line. Throws std::invalid_argument for fewer than two
/// different x.
std::vector<double> weights_of_slope(const std::vector<double>& x);

/// sum_i weights[i] values[i].
double weighted(const std::vector<double>& weights, const std::vector<double>& values);

/// The smallest step between values, 0 if they are all equal: the resolution of a digital record.
double smallest_step(std::vector<double> values);

}  // namespace tricontact::experiments
