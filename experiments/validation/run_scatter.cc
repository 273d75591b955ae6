#include "experiments/validation/run_scatter.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tricontact::experiments {

namespace {

using Values = std::vector<double>;

constexpr double dependent = 1e-10;  // of squared norms: what rounding leaves of a dependent shape

double product(const Values& a, const Values& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

void add_multiple(Values& to, double factor, const Values& of) {
    for (std::size_t n = 0; n < to.size(); ++n) to[n] += factor * of[n];
}

// Orthonormal, by Gram and Schmidt; shapes that are combinations of others are omitted.
std::vector<Values> basis_of(const std::vector<Values>& shapes) {
    std::vector<Values> basis;
    for (Values shape : shapes) {
        const double before = product(shape, shape);
        for (const Values& other : basis) add_multiple(shape, -product(shape, other), other);
        const double norm = product(shape, shape);
        if (norm <= dependent * before) continue;
        for (double& value : shape) value /= std::sqrt(norm);
        basis.push_back(std::move(shape));
    }
    return basis;
}

// Few curves cross zero where they do not vanish: there, and wherever their scatter over the mean
// is less than on the average over the values, the average counts, as if the rest were independent.
void level_out(SeriesSource& source, const Values& mean) {
    constexpr double least = 1e-3;  // of the mean's root mean square, so that it can be divided by
    const auto n_values = static_cast<double>(mean.size());
    const double size = std::sqrt(product(mean, mean) / n_values);
    Values variance(mean.size(), 0.), scale;
    double relative = 0;
    for (std::size_t n = 0; n < mean.size(); ++n) {
        for (const Values& curve : source.common) variance[n] += curve[n] * curve[n];
        scale.push_back(std::max(std::abs(mean[n]), least * size));
        if (scale[n] > 0) relative += variance[n] / (scale[n] * scale[n]) / n_values;
    }
    for (std::size_t n = 0; n < mean.size(); ++n)
        source.independent.push_back(
            std::sqrt(std::max(0., relative * scale[n] * scale[n] - variance[n])));
}

}  // namespace

Values mean_of_runs(const std::vector<Values>& runs) {
    Values mean(runs.front().size(), 0.);
    for (const Values& run : runs) add_multiple(mean, 1 / static_cast<double>(runs.size()), run);
    return mean;
}

std::vector<SeriesSource> scatter_of_mean(const std::string& name,
                                          const std::vector<Values>& runs) {
    if (runs.size() < 2) throw std::invalid_argument("the scatter of runs shows from two on");
    const auto n_runs = static_cast<double>(runs.size());
    const Values mean = mean_of_runs(runs);
    const std::size_t n_values = mean.size();
    Values place(n_values);
    std::iota(place.begin(), place.end(), 0.);
    const auto basis = basis_of({Values(n_values, 1.), mean, place});

    SeriesSource common{name, {}, {}, n_runs - 1};
    Values rest_squares(n_values, 0.);
    for (const Values& run : runs) {
        Values rest = run, curve(n_values, 0.);
        add_multiple(rest, -1, mean);
        for (const Values& shape : basis) add_multiple(curve, product(shape, rest), shape);
        add_multiple(rest, -1, curve);
        for (std::size_t n = 0; n < n_values; ++n) rest_squares[n] += rest[n] * rest[n];
        for (double& value : curve) value /= std::sqrt(n_runs * (n_runs - 1));
        common.common.push_back(std::move(curve));
    }
    level_out(common, mean);
    SeriesSource independent{
        name, {}, {}, (n_runs - 1) * static_cast<double>(n_values - basis.size())};
    const double sum = std::accumulate(rest_squares.begin(), rest_squares.end(), 0.);
    if (independent.degrees_of_freedom == 0) return {common};
    for (std::size_t n = 0; n < n_values; ++n) {
        double left = 1;  // of the independent part: the curves took the others
        for (const Values& shape : basis) left -= shape[n] * shape[n];
        const double of_all = std::max(0., left) * sum / independent.degrees_of_freedom;
        independent.independent.push_back(
            std::sqrt(std::max(of_all, rest_squares[n] / (n_runs - 1)) / n_runs));
    }
    return {common, independent};
}

}  // namespace tricontact::experiments
