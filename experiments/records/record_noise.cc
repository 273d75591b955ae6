#include "experiments/records/record_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "statistics/estimate.h"

namespace tricontact::experiments {

namespace {

constexpr double independent = 1e-10;  // of squared norms: what is left of a dependent power
constexpr std::size_t fewest_for_memory = 20;  // residuals

// Over the places of the values; the last element belongs to the place that is asked for.
double inner(const std::vector<double>& p, const std::vector<double>& q) {
    return std::inner_product(p.begin(), p.end() - 1, q.begin(), 0.);
}

// sum_ij w_i w_j c(|i - j|).
double quadratic_form(const std::vector<double>& weights, const std::vector<double>& by_lag) {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t lag = 0; lag < by_lag.size() && lag <= i; ++lag)
            sum += (lag == 0 ? 1 : 2) * weights[i] * weights[i - lag] * by_lag[lag];
    return sum;
}

}  // namespace

RecordNoise::RecordNoise(const std::vector<double>& residuals, double step) : resolution(step) {
    const std::size_t n = residuals.size();
    if (n < 3) throw std::invalid_argument("noise needs at least three residuals");
    // A line has taken two degrees of freedom.
    const double variance =
        std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.) /
        static_cast<double>(n - 2);
    standard_deviation = std::sqrt(variance);
    degrees_of_freedom = std::max(1, static_cast<int>(n) - 2);
    independent_samples = static_cast<double>(n);
    if (variance == 0) return;
    covariance = {variance};
    if (n < fewest_for_memory) return;
    const NoiseCovariance probable = noise_covariance(residuals);
    covariance = probable.by_lag;
    degrees_of_freedom = static_cast<int>(probable.degrees_of_freedom);
    correlated_samples = probable.correlated_samples;
    independent_samples = static_cast<double>(n) / correlated_samples;
    possible = probable.possible;
}

double RecordNoise::standard_error(const std::vector<double>& weights) const {
    double variance = quadratic_form(weights, covariance);
    if (standard_deviation < resolution / 2) {
        double total = 0;
        for (const double weight : weights) total += std::abs(weight);
        variance += total * total * resolution * resolution / 12;
    }
    return std::sqrt(std::max(variance, 0.));
}

double RecordNoise::coverage_factor(double confidence) const {
    const int of_samples = std::max(1, static_cast<int>(independent_samples) - 2);
    const double by_samples = statistics::student_t(confidence, of_samples);
    return possible.empty()
               ? by_samples
               : std::max(by_samples, experiments::coverage_factor(possible, confidence));
}

double RecordNoise::covariance_at(std::size_t lag) const {
    return lag < covariance.size() ? covariance[lag] : 0;
}

std::vector<double> weights_of_polynomial_at(double place, const std::vector<double>& x,
                                             int degree) {
    double scale = 0;
    for (const double value : x) scale = std::max(scale, std::abs(value - x.front()));
    // Powers made orthogonal over x one after another (Gram and Schmidt), the place among them.
    std::vector<std::vector<double>> basis;
    std::vector<double> weights(x.size(), 0.);
    for (int power = 0; power <= degree; ++power) {
        std::vector<double> p;
        for (const double value : x) p.push_back(std::pow((value - x.front()) / scale, power));
        p.push_back(std::pow((place - x.front()) / scale, power));
        if (power > 0 && scale == 0) return weights;
        if (power == 0) p.assign(p.size(), 1.);
        const double before = inner(p, p);
        for (const auto& other : basis) {
            const double part = inner(p, other) / inner(other, other);
            for (std::size_t i = 0; i < p.size(); ++i) p[i] -= part * other[i];
        }
        const double norm = inner(p, p);
        if (norm < independent * before) return weights;
        for (std::size_t i = 0; i < x.size(); ++i) weights[i] += p[i] * p.back() / norm;
        basis.push_back(std::move(p));
    }
    return weights;
}

std::vector<double> weights_of_slope(const std::vector<double>& x) {
    const double mean = std::accumulate(x.begin(), x.end(), 0.) / static_cast<double>(x.size());
    double sum_of_squares = 0;
    for (const double value : x) sum_of_squares += (value - mean) * (value - mean);
    if (!(sum_of_squares > 0))
        throw std::invalid_argument("a straight line needs two different places");
    std::vector<double> weights;
    for (const double value : x) weights.push_back((value - mean) / sum_of_squares);
    return weights;
}

double weighted(const std::vector<double>& weights, const std::vector<double>& values) {
    return std::inner_product(weights.begin(), weights.end(), values.begin(), 0.);
}

double smallest_step(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    if (values.empty()) return 0;
    // Numbers read from a text differ from multiples of the step by rounding.
    const double rounding = 1e-9 * (values.back() - values.front());
    double step = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double difference = values[i] - values[i - 1];
        if (difference > rounding && (step == 0 || difference < step)) step = difference;
    }
    return step;
}

}  // namespace tricontact::experiments
