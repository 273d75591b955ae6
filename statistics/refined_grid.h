#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace tricontact::statistics {

/// The points of an interpolant, at least one, and 19 places between each and the next: fine enough
/// for where it passes a tolerance and turns back before the next point.
inline std::vector<double> refined_grid(const std::vector<double>& points) {
    constexpr int n_between = 20;
    std::vector<double> grid;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        for (int k = 0; k < n_between; ++k)
            grid.push_back(std::lerp(points[i], points[i + 1], static_cast<double>(k) / n_between));
    grid.push_back(points.back());
    return grid;
}

}  // namespace tricontact::statistics
