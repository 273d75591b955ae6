#pragma once

#include <string>
#include <vector>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/reference.h"

namespace tricontact::benchmarks {

/// A number as pages show it.
struct NumberRow {
    std::string title;
    std::string value;  ///< with bar and unit: "16.4890 ± 0.0007 N"
    std::string source;
    std::string remark = {};
};

/// Of the targets those that are of the problem, or those of other problems.
std::vector<NumberRow> target_rows(const Problem& problem, bool is_solution);
/// What the case does not prescribe, in the units of the targets.
std::vector<NumberRow> reference_rows(const Problem& problem, const Reference& reference);
/// What can be typed about the problem.
std::vector<std::string> commands_of(const Problem& problem);
/// Without their line breaks.
std::vector<std::string> lines_of(const std::string& text);

}  // namespace tricontact::benchmarks
