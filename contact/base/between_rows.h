#pragma once

#include <algorithm>
#include <cmath>
#include <span>

namespace tricontact::contact {

/// y at `at` on the straight line through the two rows of a table next to it, whose `x` increase;
/// beyond its ends on the line through the outermost two. A single row holds everywhere.
inline double between_rows(std::span<const double> x, std::span<const double> y, double at) {
    if (x.size() == 1) return y.front();
    const auto above = std::ranges::upper_bound(x, at) - x.begin();
    const auto k =
        static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above, 1, std::ssize(x) - 1));
    return std::lerp(y[k - 1], y[k], (at - x[k - 1]) / (x[k] - x[k - 1]));
}

}  // namespace tricontact::contact
