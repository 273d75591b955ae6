#pragma once

#include <vector>

namespace tricontact::statistics {

/// A value and how well it is known, in its unit.
struct Estimate {
    double value = 0;
    double standard_error = 0;         ///< one standard deviation; 0: exact, or not stated
    double low = value, high = value;  ///< interval, of a level that its maker says

    double half_width() const { return (high - low) / 2; }
    /// Another error, independent of those that are in it: its standard error, and half the width
    /// of its interval.
    void widen(double other_error, double other_half_width);
};

/// With the interval of `factor` standard errors to both sides.
Estimate with_interval(double value, double standard_error, double factor);

/// Arithmetic mean of repeated measurements, standard error s/sqrt(n), interval by Student's t
/// (thesis A.1.1-A.1.3; DIN 1319-3). Throws std::invalid_argument for fewer than two values.
Estimate mean_of(const std::vector<double>& values, double confidence);

/// Of unordered values; NaN of none.
double median(std::vector<double> values);

/// Intervals of both do not overlap: only then is it said that they differ.
bool differ(const Estimate& a, const Estimate& b);

/// Half width of a two-sided interval in standard errors: Student's t at `confidence` in (0, 1).
double student_t(double confidence, int degrees_of_freedom);
/// The same of the normal distribution, for known standard errors.
double normal_quantile(double confidence);

}  // namespace tricontact::statistics
