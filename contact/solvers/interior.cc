#include "contact/solvers/interior.h"

#include <cmath>

namespace tricontact::contact {

std::array<double, 3> Interior::position(std::size_t i) const {
    if (!is_grid()) return points[i];
    const std::size_t n_x = axes[0].size(), n_y = axes[1].size();
    return {axes[0][i % n_x], axes[1][i / n_x % n_y], axes[2][i / (n_x * n_y)]};
}

double von_mises(const std::array<double, 6>& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    const double shear = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
    return std::sqrt((xy * xy + yz * yz + zx * zx) / 2 + 3 * shear);
}

double mean_pressure(const std::array<double, 6>& s) {
    return -(s[0] + s[1] + s[2]) / 3;
}

}  // namespace tricontact::contact
