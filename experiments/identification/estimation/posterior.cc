#include "experiments/identification/estimation/posterior.h"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/interruption.h"
#include "contact/base/special_values.h"
#include "statistics/distribution.h"
#include "statistics/ensemble_sampler.h"
#include "statistics/latin_hypercube.h"
#include "statistics/sample_quantile.h"

namespace tricontact::experiments {

namespace {

using Point = std::vector<double>;

constexpr std::uint64_t walkers_seed = 1, sampler_seed = 2, inputs_seed = 3, noise_seed = 4;
constexpr std::size_t n_walkers = 40;
// Where the linearised standard error of a coordinate is larger, or unknown, walkers start within
// this.
constexpr double widest_start = .1;
constexpr std::size_t n_predictions = 400;
constexpr int most_start_draws = 100'000;

/// Over the coordinates of the parameters.
class Density {
  public:
    /// Of errors whose correlation widens intervals `widening` times, rows count as so much fewer
    /// independent ones.
    Density(const IdentificationTask& task, double widening)
        : task_(task), weight_(1 / (widening * widening)) {
        for (const ObservedTable& table : task.tables)
            if (table.standard_errors.empty())
                errors_.resize(errors_.size() + table.observed.size(), 1.);
            else
                std::ranges::copy(table.standard_errors, std::back_inserter(errors_));
    }

    double operator()(const Point& x) const {
        for (std::size_t k = 0; k < x.size(); ++k)
            if (!(x[k] > task_.parameters[k].least() && x[k] < task_.parameters[k].largest()))
                return -contact::infinity;
        try {
            const double found = log_likelihood(task_.model(values_of(task_.parameters, x)));
            return std::isfinite(found) ? weight_ * found : -contact::infinity;
        } catch (const contact::InputError&) {
            return -contact::infinity;  // no such contact
        }
    }

  private:
    double log_likelihood(const std::vector<double>& values) const {
        const auto residuals = residuals_of(task_, values, errors_);
        double logarithm = 0;
        std::size_t row = 0;
        for (const ObservedTable& table : task_.tables) {
            double sum = 0;
            for (const std::size_t end = row + table.observed.size(); row < end; ++row)
                sum += residuals[row] * residuals[row];
            const auto n = static_cast<double>(table.observed.size() - table.n_own());
            logarithm -= table.standard_errors.empty() ? n / 2 * std::log(sum) : sum / 2;
        }
        return logarithm;
    }

    const IdentificationTask& task_;
    double weight_;
    std::vector<double> errors_;  // stated, or 1
};

/// Of mean 0 and standard deviation 1.
double normal(statistics::SplitMix64& random) {
    constexpr double least = 1e-12;  // of a probability
    return statistics::standard_quantile(statistics::Distribution::normal,
                                         least + (1 - 2 * least) * random.uniform());
}

/// Around the best values.
std::vector<Point> start_walkers(const Density& density, const IdentificationTask& task,
                                 const Identification& found) {
    statistics::SplitMix64 random(walkers_seed);
    const Point best = coordinates_of(task.parameters, found.best());
    std::vector<Point> walkers;
    for (int draw = 0; walkers.size() < n_walkers; ++draw) {
        if (draw == most_start_draws)
            throw contact::NotConverged("posterior: the model is not defined around the best fit");
        Point x = best;
        for (std::size_t k = 0; k < x.size(); ++k) {
            const FreeParameter& p = task.parameters[k];
            const double width =
                std::abs(p.slope(found.parameters[k].value)) * found.logarithmic.standard_errors[k];
            x[k] += (width < widest_start ? width : widest_start) * normal(random);
            // At a bound half of the walkers would begin beyond it: reflected.
            if (x[k] > p.largest()) x[k] = 2 * p.largest() - x[k];
            if (x[k] < p.least()) x[k] = 2 * p.least() - x[k];
        }
        if (std::isfinite(density(x))) walkers.push_back(std::move(x));
    }
    return walkers;
}

/// In coordinates, where what is positive stays so.
Point moved_by_inputs(Point x, const std::vector<Point>& steps,
                      const std::vector<FreeParameter>& parameters,
                      statistics::SplitMix64& random) {
    for (const Point& step : steps) {
        const double deviation = normal(random);
        for (std::size_t k = 0; k < x.size(); ++k) x[k] += deviation * step[k];
    }
    for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = std::clamp(x[k], parameters[k].least(), parameters[k].largest());
    return x;
}

std::vector<Interval> predicted_values(const IdentificationTask& task, const Identification& found,
                                       const std::vector<Point>& points) {
    statistics::SplitMix64 random(noise_seed);
    std::vector<std::vector<double>> values(task.n_observations());
    std::vector<double> errors;
    for (const TableFit& table : found.tables)
        std::ranges::copy(table.standard_errors, std::back_inserter(errors));
    const std::size_t every = std::max<std::size_t>(1, points.size() / n_predictions);
    for (std::size_t i = 0; i < points.size(); i += every) {
        contact::interruption_point();
        const auto predicted = task.model(values_of(task.parameters, points[i]));
        const auto residuals = residuals_of(task, predicted, errors);
        std::size_t row = 0;
        for (const ObservedTable& table : task.tables)
            for (const double observed : table.observed) {
                const double fitted = observed - errors[row] * residuals[row];
                values[row].push_back(fitted + errors[row] * normal(random));
                ++row;
            }
    }
    const double tail = (1 - task.confidence) / 2;
    std::vector<Interval> intervals;
    for (const auto& one : values)
        intervals.push_back(
            {statistics::sample_quantile(one, tail), statistics::sample_quantile(one, 1 - tail)});
    return intervals;
}

}  // namespace

Posterior sample_posterior(const IdentificationTask& task, const Identification& found,
                           const std::vector<std::vector<double>>& changes) {
    const Density density(task, found.widening.empty() ? 1 : std::ranges::max(found.widening));
    const statistics::EnsembleSample sample =
        statistics::sample_ensemble(density, start_walkers(density, task, found), sampler_seed);
    Posterior posterior{.acceptance = sample.acceptance,
                        .autocorrelation_time = std::ranges::max(sample.autocorrelation_times),
                        .effective_size = sample.effective_size(),
                        .predicted = predicted_values(task, found, sample.points)};
    const std::size_t m = task.parameters.size();
    std::vector<Point> steps;  // of coordinates
    for (const auto& change : changes) {
        Point& step = steps.emplace_back();
        for (std::size_t k = 0; k < m; ++k) {
            const double value = found.parameters[k].value;
            const FreeParameter& p = task.parameters[k];
            step.push_back(p.slope(value) * change[k] / p.unit_of_change(value));
        }
    }
    statistics::SplitMix64 random(inputs_seed);
    std::vector<std::vector<double>> values(m);
    for (const Point& x : sample.points) {
        posterior.points.push_back(
            values_of(task.parameters, moved_by_inputs(x, steps, task.parameters, random)));
        for (std::size_t k = 0; k < m; ++k) values[k].push_back(posterior.points.back()[k]);
    }
    const double tail = (1 - task.confidence) / 2;
    for (const auto& one : values) {
        posterior.median.push_back(statistics::sample_quantile(one, .5));
        posterior.interval.push_back(
            {statistics::sample_quantile(one, tail), statistics::sample_quantile(one, 1 - tail)});
        auto& row = posterior.correlation.emplace_back();
        for (const auto& other : values)
            row.push_back(gsl_stats_correlation(one.data(), 1, other.data(), 1, one.size()));
    }
    return posterior;
}

}  // namespace tricontact::experiments
