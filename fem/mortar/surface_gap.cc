#include "fem/mortar/surface_gap.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::fem {

using contact::Vector2;

void SurfaceGap::add(const SurfaceHeights& surface, const PressureTransfer& transfer, double sign) {
    const std::vector<double> means = weighted_means(transfer, surface.at_points());
    for (std::size_t k = 0; k < gap_.size(); ++k) gap_[k] += sign * means[k];
}

// The lowest point of the means, and the surfaces themselves around it on a finer lattice: what a
// paraboloid lies lower between its points is 1/128 of what it rises from one point to the next.
SurfaceGap::Least SurfaceGap::let_down(const SurfaceHeights& above, const SurfaceHeights* below) {
    const auto lowest = static_cast<std::size_t>(std::ranges::min_element(gap_) - gap_.begin());
    Least least{contact::infinity, {}};
    constexpr int parts = 8;
    for (int j = -parts; j <= parts; ++j)
        for (int i = -parts; i <= parts; ++i) {
            const Vector2 x{grid_.x[lowest] + i * grid_.spacing[0] / parts,
                            grid_.y[lowest] + j * grid_.spacing[1] / parts};
            const auto upper = above.at(x);
            const auto lower = below ? below->at(x) : std::optional(0.);
            if (upper && lower && *upper - *lower < least.height) least = {*upper - *lower, x};
        }
    for (double& gap : gap_) gap -= least.height;
    return least;
}

int SurfaceGap::nearest(int d, double x) const {
    const int n = d == 0 ? grid_.n_x : grid_.n_y;
    const double at = std::round((x - grid_.first[d]) / grid_.spacing[d]);
    return at >= 0 && at < n ? static_cast<int>(at) : -1;
}

double SurfaceGap::height(double x, double y) const {
    const int i = nearest(0, x), j = nearest(1, grid_.mirrored ? std::abs(y) : y);
    return i < 0 || j < 0 ? contact::infinity : at(i, j);
}

Vector2 SurfaceGap::slope(double x, double y) const {
    const int i = std::max(nearest(0, x), 0);
    const int j = std::max(nearest(1, grid_.mirrored ? std::abs(y) : y), 0);
    const int left = std::max(i - 1, 0), right = std::min(i + 1, grid_.n_x - 1);
    const int front = std::max(j - 1, 0), back = std::min(j + 1, grid_.n_y - 1);
    return {(at(right, j) - at(left, j)) / ((right - left) * grid_.spacing[0]),
            (at(i, back) - at(i, front)) / ((back - front) * grid_.spacing[1])};
}

}  // namespace tricontact::fem
