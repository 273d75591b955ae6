#include "experiments/records/noise_covariance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr std::size_t most_values = 20'000;  // of a longer stretch the last ones
constexpr int n_memories = 24;
constexpr std::array shares{.02, .05, .1, .2, .35, .5, .65, .8, .9, .95, .98, 1.};
constexpr double least_white = 1e-9;  // keeps the filter regular where the share is 1
constexpr double forgotten = 1e-3;    // of the variance: what lags are followed to

/// A share of the variance, and what of it is left after one sample.
struct NoiseKind {
    double share = 0, kept = 0;
};

/// How well the values fit a kind, and the variance that they then have.
struct Fitted {
    NoiseKind kind;
    double log_likelihood = 0, variance = 0;
    double variance_of_mean = 0;
};

/// Values, ones and times made independent by the filter: their inner products.
struct Products {
    double yy = 0, y1 = 0, yt = 0, one_one = 0, one_t = 0, tt = 0, log_determinant = 0;
};

Products filtered(const std::vector<double>& y, const NoiseKind& kind) {
    Products p;
    const double white = std::max(1 - kind.share, least_white);
    double variance = kind.share;  // of the state before the sample is seen
    std::array<double, 3> state{};
    const double scale = 1 / static_cast<double>(y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double innovation = variance + white, gain = variance / innovation;
        const std::array<double, 3> seen{y[i], 1., static_cast<double>(i) * scale};
        std::array<double, 3> e{};
        for (std::size_t c = 0; c < 3; ++c) {
            e[c] = seen[c] - state[c];
            state[c] = kind.kept * (state[c] + gain * e[c]);
        }
        p.log_determinant += std::log(innovation);
        p.yy += e[0] * e[0] / innovation;
        p.y1 += e[0] * e[1] / innovation;
        p.yt += e[0] * e[2] / innovation;
        p.one_one += e[1] * e[1] / innovation;
        p.one_t += e[1] * e[2] / innovation;
        p.tt += e[2] * e[2] / innovation;
        variance = kind.kept * kind.kept * variance * (1 - gain) +
                   kind.share * (1 - kind.kept * kind.kept);
    }
    return p;
}

/// Of the mean of n values of variance 1.
double variance_of_mean(const NoiseKind& kind, double n) {
    const double k = kind.kept;
    if (k == 0) return 1 / n;
    const double sum = n * (1 + k) / (1 - k) - 2 * k * (1 - std::pow(k, n)) / std::pow(1 - k, 2);
    return ((1 - kind.share) * n + kind.share * sum) / (n * n);
}

Fitted fitted(const std::vector<double>& y, const NoiseKind& kind) {
    const Products p = filtered(y, kind);
    const double determinant = p.one_one * p.tt - p.one_t * p.one_t;
    const double explained =
        (p.y1 * p.y1 * p.tt - 2 * p.y1 * p.yt * p.one_t + p.yt * p.yt * p.one_one) / determinant;
    const double left = std::max(p.yy - explained, 1e-12 * p.yy);
    const double freedom = static_cast<double>(y.size()) - 2;
    Fitted f{kind};
    f.log_likelihood = -(p.log_determinant + std::log(determinant) + freedom * std::log(left)) / 2;
    f.variance = left / (freedom - 2);  // mean of its distribution, scaled inverse chi squared
    f.variance_of_mean = f.variance * variance_of_mean(kind, static_cast<double>(y.size()));
    return f;
}

/// All kinds with their probabilities in place of the logarithms.
std::vector<Fitted> probabilities(const std::vector<double>& y) {
    std::vector<Fitted> all{fitted(y, {})};
    const double n = static_cast<double>(y.size());
    constexpr double shortest = .5;  // samples
    const double longest = n;
    const double each = std::log(1. / (n_memories * shares.size()));
    for (int m = 0; m < n_memories; ++m)
        for (const double share : shares) {
            const double memory = shortest * std::pow(longest / shortest, m / (n_memories - 1.));
            all.push_back(fitted(y, {share, std::exp(-1 / memory)}));
            all.back().log_likelihood += each;
        }
    const double most = std::ranges::max_element(all, {}, &Fitted::log_likelihood)->log_likelihood;
    double sum = 0;
    for (Fitted& f : all) sum += f.log_likelihood = std::exp(f.log_likelihood - most);
    for (Fitted& f : all) f.log_likelihood /= sum;
    return all;
}

/// What the error of the mean exceeds in 5 % of the cases.
double largest_error(const std::vector<Fitted>& all) {
    double low = 0, high = 10 * std::sqrt(all.back().variance_of_mean);
    constexpr int bisections = 40;
    for (int i = 0; i < bisections; ++i) {
        const double error = (low + high) / 2;
        double beyond = 0;
        for (const Fitted& f : all)
            beyond += f.log_likelihood * std::erfc(error / std::sqrt(2 * f.variance_of_mean));
        (beyond > .05 ? low : high) = error;
    }
    return high;
}

}  // namespace

NoiseCovariance noise_covariance(const std::vector<double>& values) {
    const auto n_used = static_cast<std::ptrdiff_t>(std::min(values.size(), most_values));
    const std::vector<double> y(values.end() - n_used, values.end());
    const double n = static_cast<double>(y.size());
    std::vector<Fitted> all = probabilities(y);
    std::ranges::sort(all, {}, &Fitted::variance_of_mean);
    auto middle = all.begin();
    for (double sum = middle->log_likelihood; sum < .5; sum += middle->log_likelihood) ++middle;
    NoiseCovariance result;
    result.by_lag = {middle->variance};
    double part = middle->variance * middle->kind.share;
    for (std::size_t lag = 1; lag < 2 * y.size() && part > forgotten * middle->variance; ++lag)
        result.by_lag.push_back(part *= middle->kind.kept);
    result.correlated_samples = std::max(1., middle->variance_of_mean * n / middle->variance);
    const double factor = largest_error(all) / std::sqrt(middle->variance_of_mean);
    int low = 1, high = std::max(1, static_cast<int>(n) - 2);
    while (low < high) {
        const int between = (low + high + 1) / 2;
        (statistics::student_t(.95, between) >= factor ? low : high) =
            statistics::student_t(.95, between) >= factor ? between : between - 1;
    }
    result.degrees_of_freedom = low;
    return result;
}

}  // namespace tricontact::experiments
