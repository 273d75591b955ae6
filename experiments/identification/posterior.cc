#include "experiments/identification/posterior.h"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "contact/error.h"
#include "contact/special_values.h"
#include "statistics/distribution.h"
#include "statistics/ensemble_sampler.h"
#include "statistics/latin_hypercube.h"
#include "statistics/sample_quantile.h"

namespace tricontact::experiments {

namespace {

using Point = std::vector<double>;

constexpr std::uint64_t walkers_seed = 1, sampler_seed = 2, inputs_seed = 3;
constexpr std::size_t n_walkers = 40;
// Where the linearised standard error is larger, or unknown, walkers start within this part.
constexpr double widest_start = .1;

/// Variables of the sampler: ln E and least_friction/mu, as far as they are free.
class Density {
  public:
    explicit Density(const IdentificationTask& task) : task_(task) {}

    Properties properties(const Point& p) const {
        Properties result = task_.start;
        std::size_t i = 0;
        if (task_.young_is_free) result.young = std::exp(p[i++]);
        if (task_.friction_is_free) result.friction = task_.least_friction / p[i];
        return result;
    }
    double operator()(const Point& p) const {
        if (task_.friction_is_free && !(p.back() > 0 && p.back() < 1)) return -contact::infinity;
        try {
            const double found = log_likelihood(task_.model(properties(p)));
            return std::isfinite(found) ? found : -contact::infinity;
        } catch (const contact::InputError&) {
            return -contact::infinity;  // no such contact
        }
    }

  private:
    double log_likelihood(const std::vector<double>& values) const {
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double error = task_.standard_errors.empty() ? 1 : task_.standard_errors[i];
            sum += std::pow((task_.observed[i] - values[i]) / error, 2);
        }
        if (!task_.standard_errors.empty()) return -sum / 2;
        return -static_cast<double>(values.size()) / 2 * std::log(sum);
    }

    const IdentificationTask& task_;
};

double start_width(const std::optional<PropertyEstimate>& estimate) {
    if (!estimate) return widest_start;
    return std::min(estimate->standard_error / estimate->value, widest_start);
}

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
    std::vector<Point> walkers;
    while (walkers.size() < n_walkers) {
        Point p;
        if (task.young_is_free)
            p.push_back(std::log(found.best.young) + start_width(found.young) * normal(random));
        if (task.friction_is_free)
            p.push_back(std::clamp(task.least_friction / found.best.friction *
                                       (1 + start_width(found.friction) * normal(random)),
                                   1e-3, 1 - 1e-3 * random.uniform()));
        if (std::isfinite(density(p))) walkers.push_back(std::move(p));
    }
    return walkers;
}

Properties moved_by_inputs(Properties at, const std::vector<Properties>& changes,
                           double least_friction, statistics::SplitMix64& random) {
    for (const Properties& change : changes) {
        const double deviation = normal(random);
        at.young += deviation * change.young;
        at.friction += deviation * change.friction;
    }
    at.friction = std::max(at.friction, least_friction);  // the contact held
    return at;
}

}  // namespace

Posterior sample_posterior(const IdentificationTask& task, const Identification& found,
                           const std::vector<Properties>& changes) {
    const Density density(task);
    const statistics::EnsembleSample sample =
        statistics::sample_ensemble(density, start_walkers(density, task, found), sampler_seed);
    Posterior posterior{.acceptance = sample.acceptance,
                        .autocorrelation_time = std::ranges::max(sample.autocorrelation_times),
                        .effective_size = sample.effective_size()};
    statistics::SplitMix64 random(inputs_seed);
    PerProperty<std::vector<double>> values;
    for (const Point& p : sample.points) {
        posterior.points.push_back(
            moved_by_inputs(density.properties(p), changes, task.least_friction, random));
        for (const Property property : both_properties)
            values[property].push_back(posterior.points.back()[property]);
    }
    const double tail = (1 - task.confidence) / 2;
    for (const Property property : both_properties) {
        posterior.median[property] = statistics::sample_quantile(values[property], .5);
        posterior.interval[property] = {statistics::sample_quantile(values[property], tail),
                                        statistics::sample_quantile(values[property], 1 - tail)};
    }
    if (task.young_is_free && task.friction_is_free)
        posterior.correlation = gsl_stats_correlation(
            values.young.data(), 1, values.friction.data(), 1, values.young.size());
    return posterior;
}

}  // namespace tricontact::experiments
