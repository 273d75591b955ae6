#pragma once

#include <vector>

namespace tricontact::contact {

/// Heights [m] of n_x * n_y cells (x fastest) as those of squares of four of them: the means of
/// what is finite; the last row or column of an odd number is alone in its.
std::vector<double> to_coarser(const std::vector<double>& height, int n_x, int n_y, int n_threads);

/// Pressures of those squares at the n_x * n_y cells, bilinear between their centres.
std::vector<double> to_finer(const std::vector<double>& pressure, int n_x, int n_y, int n_threads);

}  // namespace tricontact::contact
