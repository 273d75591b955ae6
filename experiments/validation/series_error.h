#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "experiments/validation/comparison_error.h"
#include "statistics/correlations.h"

// Measured minus computed over a whole series, in one statement of 95 %: ASME V&V 20-2009 at
// several validation points whose errors are correlated. The intervals of the single values
// (comparison_error.h) are widened by one factor until they hold all at once: simultaneous sets
// that are balanced (Beran 1988, J. Amer. Statist. Assoc. 83, 679). The factor is the quantile of
// 95 % of the largest |error|/half width of the correlated vector, drawn with a fixed seed: normal
// where all standard errors are known, multivariate t where one variance is estimated (Hothorn,
// Bretz and Westfall 2008, Biometrical J. 50, 346), sums of both (JCGM 101:2008) where some are.
// The quadratic form E' V^-1 E would need the inverse of a covariance matrix that few runs do not
// tell, and does not say where a series is off.
namespace tricontact::experiments {

/// A source of the uncertainty of a series.
struct SeriesSource {
    std::string name;
    /// What it gives to measured minus computed, one value per place, for each of its causes when
    /// that is one standard error off.
    std::vector<std::vector<double>> common;
    /// Standard errors of what each place has for itself; empty: nothing.
    std::vector<double> independent = {};
    /// By how many values its size is known. Sources of one name are told as one, with the fewest.
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

struct SeriesError {
    std::vector<ComparisonError> values;  ///< each by itself
    /// Half widths of all values together over those of each by itself, at least 1.
    double widening = 1;
    /// The least deviation of the computed values, relative to them and the same in all, that this
    /// comparison would have called a disagreement in 95 of 100 cases.
    double resolution = 0;

    double half_width(std::size_t n) const { return widening * values[n].half_width(); }
    /// The value that is furthest from zero in its half widths.
    std::size_t furthest() const;
    /// All intervals hold zero.
    bool agrees() const;
};

inline constexpr int default_series_draws = 20'000;  ///< a half width to 1 %

/// `correlation`: of the first sources, which have one common cause each; empty: independent.
SeriesError series_error(const std::vector<double>& measured, const std::vector<double>& computed,
                         const std::vector<SeriesSource>& sources,
                         const statistics::Correlations::Matrix& correlation = {},
                         int n_draws = default_series_draws);

/// "measured minus computed over n = 0 ... 12: furthest at n = 3, +2.1 ± 7.0 µm (95 % for all
/// periods together): agrees; this comparison would have seen 6 % (the same relative deviation in
/// all periods); largest contributors: friction.coefficient 59 %". `unit`: SI.
std::string statement(const SeriesError& error, const std::string& unit);

}  // namespace tricontact::experiments
