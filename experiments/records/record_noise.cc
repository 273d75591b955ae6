#include "experiments/records/record_noise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tricontact::experiments {

namespace {

constexpr double independent = 1e-10;  // of squared norms: what is left of a dependent power

// Over the places of the values; the last element belongs to the place that is asked for.
double inner(const std::vector<double>& p, const std::vector<double>& q) {
    return std::inner_product(p.begin(), p.end() - 1, q.begin(), 0.);
}

}  // namespace

RecordNoise::RecordNoise(const std::vector<double>& residuals, double step) : resolution(step) {
    const std::size_t n = residuals.size();
    if (n < 3) throw std::invalid_argument("noise needs at least three residuals");
    const auto covariance = [&](std::size_t lag) {
        double sum = 0;
        for (std::size_t i = lag; i < n; ++i) sum += residuals[i] * residuals[i - lag];
        return sum / static_cast<double>(n);
    };
    const double variance = covariance(0);
    // A line has taken two degrees of freedom.
    standard_deviation = std::sqrt(variance * static_cast<double>(n) / static_cast<double>(n - 2));
    if (variance == 0) return;
    for (std::size_t lag = 1; lag < n / 4; ++lag) {
        const double rho = covariance(lag) / variance;
        if (rho <= 0) break;
        autocorrelation.push_back(rho);
    }
}

double RecordNoise::standard_error(const std::vector<double>& weights) const {
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t lag = 0; lag < autocorrelation.size() && lag <= i; ++lag)
            sum += (lag == 0 ? 1 : 2) * weights[i] * weights[i - lag] * autocorrelation[lag];
    double variance = standard_deviation * standard_deviation * std::max(sum, 0.);
    if (standard_deviation < resolution / 2) {
        double total = 0;
        for (const double weight : weights) total += std::abs(weight);
        variance += total * total * resolution * resolution / 12;
    }
    return std::sqrt(variance);
}

double RecordNoise::correlated_samples() const {
    return 2 * std::accumulate(autocorrelation.begin(), autocorrelation.end(), 0.) - 1;
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
