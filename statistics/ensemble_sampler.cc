#include "statistics/ensemble_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "contact/base/error.h"
#include "statistics/initial_sequence.h"
#include "statistics/latin_hypercube.h"

namespace tricontact::statistics {

namespace {

using Points = std::vector<std::vector<double>>;

constexpr double stretch = 2;  // Goodman and Weare's a
constexpr int first_steps = 500;
constexpr double steps_per_time = 50;  // autocorrelation times that a chain has to last

/// All walkers at one time after another.
class Ensemble {
  public:
    Ensemble(const LogDensity& log_density, Points walkers, std::uint64_t seed)
        : log_density_(log_density), walkers_(std::move(walkers)), random_(seed) {
        for (const std::vector<double>& walker : walkers_)
            densities_.push_back(log_density_(walker));
        if (!std::ranges::all_of(densities_, [](double d) { return std::isfinite(d); }))
            throw std::invalid_argument("walkers start where the density is positive");
    }

    void step() {
        const std::size_t half = walkers_.size() / 2;
        for (std::size_t i = 0; i < walkers_.size(); ++i) {
            const bool is_first = i < half;
            const std::size_t begin = is_first ? half : 0,
                              n = is_first ? walkers_.size() - half : half;
            move(i, begin + random_.below(n));
        }
        ++n_steps_;
    }
    const Points& walkers() const { return walkers_; }
    double acceptance() const {
        return static_cast<double>(n_taken_) /
               (static_cast<double>(n_steps_) * static_cast<double>(walkers_.size()));
    }

  private:
    void move(std::size_t i, std::size_t other) {
        const double u = random_.uniform(), z = std::pow((stretch - 1) * u + 1, 2) / stretch;
        std::vector<double> proposal = walkers_[other];
        const auto n = static_cast<double>(proposal.size());
        for (std::size_t d = 0; d < proposal.size(); ++d)
            proposal[d] += z * (walkers_[i][d] - walkers_[other][d]);
        const double density = log_density_(proposal);
        const double ratio = (n - 1) * std::log(z) + density - densities_[i];
        if (!(std::log1p(-random_.uniform()) < ratio)) return;  // 1 - u is in (0, 1]
        walkers_[i] = std::move(proposal);
        densities_[i] = density;
        ++n_taken_;
    }

    const LogDensity& log_density_;
    Points walkers_;
    std::vector<double> densities_;
    SplitMix64 random_;
    std::size_t n_taken_ = 0, n_steps_ = 0;
};

/// Of the ensemble's mean of one variable.
double autocorrelation_time(std::span<const Points> history, std::size_t variable) {
    std::vector<double> means;
    for (const Points& walkers : history) {
        double mean = 0;
        for (const std::vector<double>& walker : walkers) mean += walker[variable];
        means.push_back(mean / static_cast<double>(walkers.size()));
    }
    return static_cast<double>(means.size()) / independent_values(means);
}

}  // namespace

double EnsembleSample::effective_size() const {
    return static_cast<double>(points.size()) / std::ranges::max(autocorrelation_times);
}

EnsembleSample sample_ensemble(const LogDensity& log_density, Points walkers, std::uint64_t seed,
                               int most_steps) {
    const std::size_t n_variables = walkers.empty() ? 0 : walkers.front().size();
    if (n_variables == 0 || walkers.size() < 2 * n_variables)
        throw std::invalid_argument("twice as many walkers as variables, at least");
    Ensemble ensemble(log_density, std::move(walkers), seed);
    std::vector<Points> history;
    for (std::size_t n = first_steps; n <= static_cast<std::size_t>(most_steps); n *= 2) {
        while (history.size() < n) {
            ensemble.step();
            history.push_back(ensemble.walkers());
        }
        EnsembleSample sample{.acceptance = ensemble.acceptance(),
                              .n_steps = static_cast<int>(n - n / 2)};
        for (std::size_t d = 0; d < n_variables; ++d)
            sample.autocorrelation_times.push_back(
                autocorrelation_time(std::span(history).subspan(n / 2), d));
        if (sample.n_steps < steps_per_time * std::ranges::max(sample.autocorrelation_times))
            continue;
        for (std::size_t t = n / 2; t < n; ++t)
            sample.points.insert(sample.points.end(), history[t].begin(), history[t].end());
        return sample;
    }
    throw contact::NotConverged(fmt::format(
        "posterior: the walkers still remember where they were after {} steps; the data may not "
        "distinguish the properties",
        most_steps));
}

}  // namespace tricontact::statistics
