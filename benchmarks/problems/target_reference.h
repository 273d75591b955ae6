#pragma once

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/reference.h"
#include "benchmarks/submissions/submission.h"

namespace tricontact::benchmarks {

/// Adds to the reference of a problem's case what its targets have beyond the quantities of a
/// reference, such as c/a or Kalker's C11: value, bar, source and the problem's own title. Ratios
/// that follow from a number that codes have, such as C11 from F_T, say from which.
void add_targets(Reference& reference, const Problem& problem);

/// Throws contact::InputError that names a ratio of a submission which is none of the problem's
/// targets, and those that are.
void check_stated_targets(const Submission& submission, const Problem* problem);

}  // namespace tricontact::benchmarks
