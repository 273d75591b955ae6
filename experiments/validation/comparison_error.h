#pragma once

#include <limits>
#include <string>
#include <vector>

#include "statistics/estimate.h"

// What separates a measured quantity from a computed one, and how well that is known: ASME V&V
// 20-2009, Standard for Verification and Validation in Computational Fluid Dynamics and Heat
// Transfer; uncertainties after JCGM 100:2008 (GUM).
namespace tricontact::experiments {

/// One source of the uncertainty of a comparison.
struct UncertaintySource {
    std::string name;           ///< "friction.coefficient", "repeated runs", "mesh"
    double standard_error = 0;  ///< that it gives to measured minus computed, in their unit
    /// By how many values its standard error is known.
    double degrees_of_freedom = std::numeric_limits<double>::infinity();
};

/// Measured minus computed. V&V 20 takes the other sign of E.
struct ComparisonError {
    double measured = 0, computed = 0;
    std::vector<UncertaintySource> sources;
    /// Twice the sum of the covariances of what the sources give, in the unit squared; 0: they are
    /// independent.
    double covariance = 0;

    double difference() const { return measured - computed; }
    /// u_val, (4-2-1): the root of the sum of squares of all sources and their covariances.
    double standard_error() const;
    /// Of the interval of 95 % of the difference: of the sum of normal errors and, where few values
    /// tell one, of Student's t times it (see student_sum.h).
    double half_width() const;
    /// The interval holds zero.
    bool agrees() const;
    /// The least deviation of the computed value, relative to it, that this comparison would have
    /// called a disagreement in 95 of 100 cases: the half width and the normal quantile of 95 %
    /// times u_val.
    double resolution() const;
    /// The sources with their shares of u_val^2, the largest first, and "correlations" with the
    /// share of the covariances, which may be negative; none if nothing is uncertain.
    std::vector<std::pair<std::string, double>> shares() const;
};

/// No value from `difference` to `difference + creep` lies within a half width of zero.
bool is_excluded(double difference, double creep, double half_width);

/// "substrate.young 61 %, repeated runs 22 %": the largest, and correlations that take something
/// off.
std::string largest_contributors(const ComparisonError& error, std::size_t most = 4);

/// "+1.4 ± 6.8 µm": a difference with the half width of its interval. `unit`: SI.
std::string difference_text(double difference, double half_width, const std::string& unit);

/// "measured minus computed: +1.4 ± 6.8 µm (95 %): agrees; this comparison would have seen 12 %;
/// largest contributors: substrate.young 61 %, repeated runs 22 %". `unit`: SI.
std::string statement(const ComparisonError& error, const std::string& unit);

}  // namespace tricontact::experiments
