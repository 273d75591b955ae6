#pragma once

#include <vector>

namespace tricontact::experiments {

/// A standard error, relative, and its probability.
struct PossibleError {
    double ratio = 1, probability = 1;
};

/// What a stretch of evenly sampled noise says of its covariances: white noise, and beside it one
/// that forgets exponentially (autoregressive of first order), of unknown shares and memory. Each
/// pair of share and memory has the probability that the values give it - the restricted likelihood
/// about a straight line (Harville 1977, J. Amer. Statist. Assoc. 72, 320), by Kalman's filter -
/// and noise without a memory half of it beforehand; memories from half a sample to the whole
/// stretch are equally probable on a logarithmic scale. What follows is averaged over all: so a
/// memory that the stretch is too short to show counts by how probable it still is.
struct NoiseCovariance {
    std::vector<double> by_lag;  ///< [0]: the variance, in the square of the values' unit
    /// Of the variance of the mean of all values, by how it varies over what is probable.
    double degrees_of_freedom = 1;
    double correlated_samples = 1;  ///< that count as one independent
    /// Standard errors of the mean that are possible, over that of `by_lag`.
    std::vector<PossibleError> possible;
};

/// Half width of the interval of an error that is normal with one of these standard errors.
double coverage_factor(const std::vector<PossibleError>& possible, double confidence);

/// `values`: at least five that are not all equal.
NoiseCovariance noise_covariance(const std::vector<double>& values);

}  // namespace tricontact::experiments
