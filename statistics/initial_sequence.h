#pragma once

#include <span>

namespace tricontact::statistics {

/// Mean of correlated values.
struct Mean {
    double value = 0;
    double error = 0;  ///< half width of the 95 % interval
};

/// How many independent values would tell the mean as well: n/(1 + 2 sum of the autocorrelations),
/// these summed in pairs of neighbouring lags while the pairs are positive, and no pair counted
/// larger than the one before. Initial monotone sequence, Geyer (1992), Statistical Science 7,
/// 473. Between 2 and n: what alternates is not taken to tell more. At least two values.
double independent_values(std::span<const double> values);

/// Mean of consecutive values of a stationary process, with Student's interval of as many
/// independent ones. At least two values.
Mean initial_sequence_mean(std::span<const double> values);

}  // namespace tricontact::statistics
