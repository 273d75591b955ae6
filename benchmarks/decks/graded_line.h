#pragma once

#include <vector>

namespace tricontact::benchmarks {

/// Nodes of the coarsest mesh along a direction: `count` equal elements of `size` from `start` on,
/// then elements that grow by a common factor of at most `growth`, the last of which ends at `end`.
/// Needs start + count size < end, or equal: then there is nothing beyond.
std::vector<double> graded_line(double start, double size, int count, double end, double growth);

/// Every element divided into 2^level equal ones: nodes of the coarse line stay nodes.
std::vector<double> refined_line(const std::vector<double>& line, int level);

/// The line about 0 of a line that begins at 0.
std::vector<double> mirrored_line(const std::vector<double>& line);

/// The part of a line up to its last node within `reach`, to rounding.
std::vector<double> line_within(const std::vector<double>& line, double reach);

}  // namespace tricontact::benchmarks
