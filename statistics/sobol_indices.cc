#include "statistics/sobol_indices.h"

#include <gsl/gsl_qrng.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace tricontact::statistics {

namespace {

using Rows = std::vector<std::vector<double>>;

constexpr int most_variables_of_indices = 20;  // half of what GSL's sequence has

/// Points of the sequence, its first one, the corner, left out.
Rows sequence(int n_points, int n_variables) {
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> generator(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(n_variables)), gsl_qrng_free);
    Rows points(n_points, std::vector<double>(n_variables));
    for (std::vector<double>& point : points) gsl_qrng_get(generator.get(), point.data());
    return points;
}

/// Values of one function at A, B and the n_variables mixed matrices, sample by sample.
struct Values {
    std::vector<double> at_a, at_b;
    Rows mixed;  // per variable
};

SobolIndices indices_of(const Values& values) {
    std::vector<std::size_t> defined;
    for (std::size_t j = 0; j < values.at_a.size(); ++j) {
        bool is_defined = std::isfinite(values.at_a[j]) && std::isfinite(values.at_b[j]);
        for (const auto& column : values.mixed) is_defined &= std::isfinite(column[j]);
        if (is_defined) defined.push_back(j);
    }
    SobolIndices result;
    const auto n = static_cast<double>(defined.size());
    if (defined.size() < 2) return result;
    for (const std::size_t j : defined) result.mean += (values.at_a[j] + values.at_b[j]) / (2 * n);
    for (const std::size_t j : defined)
        result.variance += (std::pow(values.at_a[j] - result.mean, 2) +
                            std::pow(values.at_b[j] - result.mean, 2)) /
                           (2 * n - 1);
    for (const auto& column : values.mixed) {
        double first = 0, total = 0;
        for (const std::size_t j : defined) {
            first += values.at_b[j] * (column[j] - values.at_a[j]) / n;
            total += std::pow(values.at_a[j] - column[j], 2) / (2 * n);
        }
        const bool varies = result.variance > 0;
        result.first.push_back(varies ? first / result.variance : 0);
        result.total.push_back(varies ? total / result.variance : 0);
    }
    return result;
}

}  // namespace

SobolSample sobol_indices(const SampledFunctions& functions, int n_variables, int n_samples) {
    if (n_variables < 1 || n_variables > most_variables_of_indices || n_samples < 2)
        throw std::invalid_argument("indices are those of 1 to 20 variables and 2 samples or more");
    const Rows both = sequence(n_samples, 2 * n_variables);
    SobolSample sample;
    for (const bool is_b : {false, true})
        for (const std::vector<double>& point : both) {
            const auto begin = point.begin() + (is_b ? n_variables : 0);
            sample.points.emplace_back(begin, begin + n_variables);
        }
    for (const std::vector<double>& point : sample.points)
        sample.values.push_back(functions(point));
    const std::size_t n_functions = sample.values.front().size(), n = both.size();
    std::vector<Values> values(n_functions);
    for (std::size_t f = 0; f < n_functions; ++f) {
        values[f].mixed.assign(n_variables, std::vector<double>(n));
        for (std::size_t j = 0; j < n; ++j) {
            values[f].at_a.push_back(sample.values[j][f]);
            values[f].at_b.push_back(sample.values[n + j][f]);
        }
    }
    for (int i = 0; i < n_variables; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            std::vector<double> point = sample.points[j];
            point[i] = sample.points[n + j][i];
            const std::vector<double> at = functions(point);
            for (std::size_t f = 0; f < n_functions; ++f) values[f].mixed[i][j] = at[f];
        }
    for (const Values& one : values) sample.indices.push_back(indices_of(one));
    return sample;
}

}  // namespace tricontact::statistics
