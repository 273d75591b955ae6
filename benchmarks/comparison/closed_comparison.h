#pragma once

#include <string_view>

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// Whether a problem of the catalogue without a case is compared: "patch_test", "wedge",
/// "complete_punch", "rounded_punch_plane", "pin_in_hole".
bool has_closed_comparison(std::string_view problem);

/// Compares with the closed form of such a problem, `submission.problem`. Throws what compare()
/// throws.
Comparison compare_closed(Submission submission);

}  // namespace tricontact::benchmarks
