#pragma once

#include <string>
#include <vector>

#include "experiments/validation/series_error.h"

namespace tricontact::experiments {

/// What a few repeated series tell of the error of their mean, as sources of the same name.
///
/// So few runs do not tell a covariance matrix. Their deviations from the mean are taken apart:
/// - what runs have in common over their values is a constant, a multiple of the mean, and a drift
///   in proportion to the place: least squares, and the scatter of these curves, by one value less
///   than there are runs; where it is smaller, over the mean, than on the average over the values,
///   as where curves of two runs cross, the average counts;
/// - the rest is independent from value to value, with the variance of all of them or that of the
///   value's own rest, whichever is larger: so a few values that scatter more than the others, as
///   those of a transient, are not told too well.
/// Two runs do not show whether they differ in several of these ways at once; see
/// docs/explanation/experiment.md for how often statements then hold. Throws std::invalid_argument
/// for fewer than two runs.
std::vector<SeriesSource> scatter_of_mean(const std::string& name,
                                          const std::vector<std::vector<double>>& runs);

/// Of runs, value by value.
std::vector<double> mean_of_runs(const std::vector<std::vector<double>>& runs);

}  // namespace tricontact::experiments
