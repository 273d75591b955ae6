#pragma once

#include "experiments/records/experiment.h"

namespace tricontact::experiments {

/// Rolling period [s] as seen in the recorded shift alone, known to begin at `start` [s] and to
/// number `periods`: the lag at which the autocorrelation of the shift's speed is highest, refined
/// by its multiples. Both halves of a period look alike when the table does not wobble, so that the
/// longest of nearly equal peaks counts; rest after the rolling must be shorter than the rolling.
/// Throws contact::InputError if no period stands out.
double shift_period(const Record& record, double start, int periods);

}  // namespace tricontact::experiments
