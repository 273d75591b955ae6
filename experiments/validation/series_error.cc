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

/// Differences of a series that agrees, over the half widths that it would be given.
class AgreeingSeries {
  public:
    AgreeingSeries(const std::vector<ComparisonError>& values, std::vector<SeriesSource> sources,
                   const statistics::Correlations::Matrix& correlation)
        : sources_(std::move(sources)), drawn_(values), scales_(sources_.size(), 1.) {
        for (const SeriesSource& source : sources_) {
            const auto& told = drawn_.front().sources;
            const auto same = std::ranges::find(told, source.name, &UncertaintySource::name);
            told_as_.push_back(static_cast<std::size_t>(same - told.begin()));
            std::vector<double>& variance = variances_.emplace_back();
            for (std::size_t n = 0; n < values.size(); ++n)
                variance.push_back(variance_at(source, n));
        }
        decorrelate(sources_, correlation);
    }

    /// 0 where nothing is uncertain.
    std::vector<double> draw() {
        std::vector<double> differences(drawn_.size(), 0.);
        for (std::size_t s = 0; s < sources_.size(); ++s) draw(s, differences);
        for (std::size_t n = 0; n < drawn_.size(); ++n)
            if (const double half = half_width(n); half > 0) differences[n] /= half;
        return differences;
    }

  private:
    void draw(std::size_t s, std::vector<double>& differences) {
        const SeriesSource& source = sources_[s];
        for (const std::vector<double>& cause : source.common) {
            const double z = gauss_(random_);
            for (std::size_t n = 0; n < cause.size(); ++n) differences[n] += z * cause[n];
        }
        for (std::size_t n = 0; n < source.independent.size(); ++n)
            differences[n] += gauss_(random_) * source.independent[n];
        if (std::isfinite(source.degrees_of_freedom))
            scales_[s] = boost::random::chi_squared_distribution<double>(source.degrees_of_freedom)(
                             random_) /
                         source.degrees_of_freedom;
    }

    double half_width(std::size_t n) {
        std::vector<UncertaintySource>& told = drawn_[n].sources;
        for (UncertaintySource& one : told) one.standard_error = 0;
        for (std::size_t s = 0; s < sources_.size(); ++s)
            told[told_as_[s]].standard_error += scales_[s] * variances_[s][n];
        for (UncertaintySource& one : told) one.standard_error = std::sqrt(one.standard_error);
        const double error = drawn_[n].standard_error();
        return error > 0 ? student_factor(drawn_[n].degrees_of_freedom()) * error : 0;
    }

    // Looked up: all draws together ask for it some 10^5 times.
    double student_factor(int degrees_of_freedom) {
        constexpr int looked_up = 1000;
        if (degrees_of_freedom > looked_up) return statistics::normal_quantile(series_confidence);
        const auto index = static_cast<std::size_t>(degrees_of_freedom);
        while (student_factors_.size() <= index)
            student_factors_.push_back(statistics::student_t(
                series_confidence, std::max(1, static_cast<int>(student_factors_.size()))));
        return student_factors_[index];
    }

    std::vector<SeriesSource> sources_;
    std::vector<ComparisonError> drawn_;
    std::vector<double> scales_;                  // drawn over true variances
    std::vector<std::vector<double>> variances_;  // of each source at each value
    std::vector<std::size_t> told_as_;            // which of a value's sources each one is part of
    std::vector<double> student_factors_;
    boost::random::mt19937_64 random_{series_seed};
    boost::random::normal_distribution<double> gauss_;
};

// The relative deviation from which on one of the values is called a disagreement, with the errors
// of a draw.
double seen_from(const SeriesError& error, const std::vector<double>& draw) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t n = 0; n < draw.size(); ++n) {
        const double computed = error.values[n].computed;
        if (computed == 0) continue;
        const double towards = computed > 0 ? draw[n] : -draw[n];
        least = std::min(
            least, (error.widening - towards) * error.values[n].half_width() / std::abs(computed));
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
    AgreeingSeries series(error.values, sources, correlation);
    std::vector<std::vector<double>> draws;
    std::vector<double> largest, seen;
    for (int i = 0; i < n_draws; ++i) {
        const std::vector<double>& draw = draws.emplace_back(series.draw());
        largest.push_back(0);
        for (const double x : draw) largest.back() = std::max(largest.back(), std::abs(x));
    }
    error.widening = std::max(1., statistics::sample_quantile(largest, series_confidence));
    for (const std::vector<double>& draw : draws) seen.push_back(seen_from(error, draw));
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
