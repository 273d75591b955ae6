#include "dynamics/block_bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace tricontact::dynamics {
namespace {

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

/// Autocovariance at lags 0 to `longest`.
std::vector<double> autocovariance(std::span<const double> values, int longest) {
    const double mean = mean_of(values), n = static_cast<double>(values.size());
    std::vector<double> covariance(static_cast<std::size_t>(longest) + 1);
    for (std::size_t lag = 0; lag < covariance.size(); ++lag)
        for (std::size_t i = lag; i < values.size(); ++i)
            covariance[lag] += (values[i] - mean) * (values[i - lag] - mean) / n;
    return covariance;
}

/// Lag after which the correlation stays insignificant for `run` lags.
int last_correlated_lag(const std::vector<double>& covariance, int n, int run) {
    const double bound = 2 * std::sqrt(std::log10(n) / n) * covariance[0];
    int quiet = 0;
    for (int lag = 1; lag < static_cast<int>(covariance.size()); ++lag) {
        quiet = std::abs(covariance[static_cast<std::size_t>(lag)]) < bound ? quiet + 1 : 0;
        if (quiet == run) return lag - run;
    }
    return static_cast<int>(covariance.size()) - 1;
}

}  // namespace

int block_length(std::span<const double> values) {
    const int n = static_cast<int>(values.size());
    const int run = std::max(5, static_cast<int>(std::sqrt(std::log10(n))));
    const int longest = std::min(n - 1, static_cast<int>(std::ceil(std::sqrt(n))) + run);
    const std::vector<double> covariance = autocovariance(values, longest);
    if (!(covariance[0] > 0)) return 1;
    const int bandwidth =
        std::min(2 * std::max(1, last_correlated_lag(covariance, n, run)), longest);
    double spectrum = covariance[0], slope = 0;  // g(0) and G of the paper
    for (int lag = 1; lag <= bandwidth; ++lag) {
        const double share = static_cast<double>(lag) / bandwidth;
        const double window = share <= 0.5 ? 1 : 2 * (1 - share);
        const double term = 2 * window * covariance[static_cast<std::size_t>(lag)];
        spectrum += term;
        slope += lag * term;
    }
    const double length = std::cbrt(2 * slope * slope / (4. / 3 * spectrum * spectrum) * n);
    return static_cast<int>(std::clamp(std::ceil(length), 1., std::max(1., n / 3.)));
}

Mean block_bootstrap_mean(std::span<const double> values) {
    const std::size_t n = values.size(), length = static_cast<std::size_t>(block_length(values));
    std::vector<double> sums(2 * n + 1);  // of the values in a circle
    for (std::size_t i = 0; i < 2 * n; ++i) sums[i + 1] = sums[i] + values[i % n];
    constexpr int n_resamples = 1000;  // 2.5 % of them are 25: the interval is known to 10 %
    const std::size_t n_blocks = (n + length - 1) / length;
    std::mt19937_64 generator(1);
    std::vector<double> means;
    for (int i = 0; i < n_resamples; ++i) {
        double sum = 0;
        for (std::size_t block = 0; block < n_blocks; ++block) {
            const std::size_t begin = generator() % n;
            sum += sums[begin + length] - sums[begin];
        }
        means.push_back(sum / static_cast<double>(n_blocks * length));
    }
    std::sort(means.begin(), means.end());
    // Blocks are as many independent values; so few need Bessel's factor and Student's quantile,
    // Abramowitz and Stegun (1964), eq. 26.7.5, to first order.
    const double freedom = std::max(1., static_cast<double>(n) / static_cast<double>(length) - 1);
    const double few = std::sqrt(1 + 1 / freedom) * (1 + (1.96 * 1.96 + 1) / (4 * freedom));
    return {mean_of(values), few * (means[974] - means[24]) / 2};
}

}  // namespace tricontact::dynamics
