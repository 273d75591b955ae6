#pragma once

#include <span>

namespace tricontact::dynamics {

/// Mean of correlated values.
struct Mean {
    double value = 0;
    double error = 0;  ///< half width of the 95 % interval
};

/// Length of the blocks of a circular bootstrap that makes the error of its variance least, from
/// the autocorrelation: Politis and White (2004), Econometric Reviews 23, with the correction of
/// Patton, Politis and White (2009). Between 1 and a third of the values.
int block_length(std::span<const double> values);

/// Mean of consecutive values of a stationary process, its interval by the circular block
/// bootstrap: Politis and Romano (1992). The same values give the same interval. At least two
/// values.
Mean block_bootstrap_mean(std::span<const double> values);

}  // namespace tricontact::dynamics
