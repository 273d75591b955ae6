#pragma once

#include <vector>

#include "experiments/records/record_checks.h"

namespace tricontact::experiments {

/// A line in the spectrum of the rest's residuals about a straight line, sampled at `interval` [s]:
/// one frequency beside which the others within a factor of 1.6 are so weak that noise has such a
/// line in one of a thousand records. Below the twelfth of the spectrum, where drift and noise that
/// remembers have most, and below the resolution [m] none is looked for.
void find_hum(const std::vector<double>& residuals, double interval, double resolution,
              RecordFindings& findings);

}  // namespace tricontact::experiments
