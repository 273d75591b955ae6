#include "experiments/validation/series_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/random/chi_squared_distribution.hpp>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>

#include "report/format.h"
#include "statistics/sample_quantile.h"

namespace tricontact::experiments {

namespace {

constexpr double series_confidence = .95;
constexpr std::uint64_t series_seed = 20;

double squared(double x) {
    return x * x;
}

double variance_at(const SeriesSource& source, std::size_t n) {
    double sum = source.independent.empty() ? 0. : squared(source.independent[n]);
    for (const std::vector<double>& cause : source.common) sum += squared(cause[n]);
    return sum;
}

// The sources at one value, those of one name as one.
std::vector<UncertaintySource> sources_at(const std::vector<SeriesSource>& sources, std::size_t n) {
    std::vector<UncertaintySource> result;
    for (const SeriesSource& source : sources) {
        const double error = std::sqrt(variance_at(source, n));
        const auto same = std::ranges::find(result, source.name, &UncertaintySource::name);
        if (same == result.end()) {
            result.push_back({source.name, error, source.degrees_of_freedom});
            continue;
        }
        same->standard_error = std::hypot(same->standard_error, error);
        same->degrees_of_freedom = std::min(same->degrees_of_freedom, source.degrees_of_freedom);
    }
    return result;
}

// Their covariances at one value: of the first sources, which are correlated.
double covariance_at(const std::vector<SeriesSource>& sources, std::size_t n,
                     const statistics::Correlations::Matrix& correlation) {
    std::vector<double> changes;
    for (std::size_t i = 0; i < correlation.size(); ++i)
        changes.push_back(sources[i].common.front()[n]);
    return statistics::covariance_part(changes, correlation);
}

// The first sources by causes that are independent of each other.
void decorrelate(std::vector<SeriesSource>& sources,
                 const statistics::Correlations::Matrix& correlation) {
    const std::size_t n_correlated = correlation.size();
    const auto root = statistics::triangular_root(correlation, n_correlated);
    for (std::size_t k = 0; k < n_correlated; ++k) {
        std::vector<double>& cause = sources[k].common.front();
        for (double& change : cause) change *= root[k][k];
        for (std::size_t i = k + 1; i < n_correlated; ++i)
            for (std::size_t n = 0; n < cause.size(); ++n)
                cause[n] += root[i][k] * sources[i].common.front()[n];
    }
}

/// Errors of a series as its sources tell them, over the half widths of its values by themselves:
/// sizes that few values tell are drawn as they may be, given what was seen.
class SeriesErrors {
  public:
    SeriesErrors(const std::vector<ComparisonError>& values, std::vector<SeriesSource> sources,
                 const statistics::Correlations::Matrix& correlation)
        : sources_(std::move(sources)) {
        for (const ComparisonError& value : values) half_widths_.push_back(value.half_width());
        decorrelate(sources_, correlation);
    }

    /// 0 where nothing is uncertain.
    std::vector<double> draw() {
        std::vector<double> errors(half_widths_.size(), 0.);
        for (const SeriesSource& source : sources_) draw(source, errors);
        for (std::size_t n = 0; n < errors.size(); ++n)
            errors[n] = half_widths_[n] > 0 ? errors[n] / half_widths_[n] : 0;
        return errors;
    }

  private:
    void draw(const SeriesSource& source, std::vector<double>& errors) {
        double scale = 1;
        if (const double nu = source.degrees_of_freedom; std::isfinite(nu))
            scale = std::sqrt(nu / boost::random::chi_squared_distribution<double>(nu)(random_));
        for (const std::vector<double>& cause : source.common) {
            const double z = scale * gauss_(random_);
            for (std::size_t n = 0; n < cause.size(); ++n) errors[n] += z * cause[n];
        }
        for (std::size_t n = 0; n < source.independent.size(); ++n)
            errors[n] += scale * gauss_(random_) * source.independent[n];
    }

    std::vector<SeriesSource> sources_;
    std::vector<double> half_widths_;
    boost::random::mt19937_64 random_{series_seed};
    boost::random::normal_distribution<double> gauss_;
};

// The relative deviation from which on one of the values is called a disagreement, with the errors
// of a draw.
double seen_from(const SeriesError& error, const std::vector<double>& half_widths,
                 const std::vector<double>& draw) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < draw.size(); ++n) {
        const double computed = error.values[n].computed;
        if (computed == 0) continue;
        const double towards = computed > 0 ? draw[n] : -draw[n];
        least = std::min(least, (error.widening - towards) * half_widths[n] / std::abs(computed));
    }
    return std::max(0., least);
}

}  // namespace

std::size_t SeriesError::furthest() const {
    std::size_t furthest = 0;
    double largest = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double difference = std::abs(values[n].difference());
        if (difference == 0) continue;  // of nothing that is uncertain: agrees
        const double ratio = difference / values[n].half_width();
        if (ratio > largest) {
            largest = ratio;
            furthest = n;
        }
    }
    return furthest;
}

bool SeriesError::agrees() const {
    const std::size_t n = furthest();
    return std::abs(values[n].difference()) <= half_width(n);
}

SeriesError series_error(const std::vector<double>& measured, const std::vector<double>& computed,
                         const std::vector<SeriesSource>& sources,
                         const statistics::Correlations::Matrix& correlation, int n_draws) {
    SeriesError error;
    for (std::size_t n = 0; n < measured.size(); ++n)
        error.values.push_back({measured[n], computed[n], sources_at(sources, n),
                                covariance_at(sources, n, correlation)});
    SeriesErrors series(error.values, sources, correlation);
    std::vector<std::vector<double>> draws;
    std::vector<double> largest, seen;
    for (int i = 0; i < n_draws; ++i) {
        const std::vector<double>& draw = draws.emplace_back(series.draw());
        largest.push_back(0);
        for (const double x : draw) largest.back() = std::max(largest.back(), std::abs(x));
    }
    error.widening = std::max(1., statistics::sample_quantile(largest, series_confidence));
    std::vector<double> half_widths;
    for (const ComparisonError& value : error.values) half_widths.push_back(value.half_width());
    for (const std::vector<double>& draw : draws)
        seen.push_back(seen_from(error, half_widths, draw));
    error.resolution = statistics::sample_quantile(seen, series_confidence);
    return error;
}

std::string statement(const SeriesError& error, const std::string& unit) {
    const std::size_t n = error.furthest();
    return fmt::format(
        "measured minus computed over n = 0 ... {}: furthest at n = {}, {} (95 % for all periods "
        "together): {}; this comparison would have seen {} % (the same relative deviation in all "
        "periods); largest contributors: {}",
        error.values.size() - 1, n,
        difference_text(error.values[n].difference(), error.half_width(n), unit),
        error.agrees() ? "agrees" : "disagrees", report::significant(100 * error.resolution, 2),
        largest_contributors(error.values[n]));
}

}  // namespace tricontact::experiments
