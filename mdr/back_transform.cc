#include "mdr/back_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::mdr {

double back_transform(std::span<const double> positions, std::span<const double> line_load,
                      double r) {
    const std::size_t n = positions.size();
    if (n < 2 || line_load.size() != n || positions.front() != 0)
        throw std::domain_error("back_transform: needs two or more loads, the first one at 0");
    if (!(r >= 0)) throw std::domain_error("back_transform: the radius must not be negative");
    if (r >= positions.back()) return 0;

    double sum = 0;
    if (r < positions[1]) {
        const double h = positions[1];
        sum = 2 * (line_load[1] - line_load[0]) / (h * h) * std::sqrt((h - r) * (h + r));
    }
    // ∫ dx/sqrt(x^2 - r^2) = log(x + sqrt(x^2 - r^2))
    auto primitive = [r](double x) { return std::log(x + std::sqrt((x - r) * (x + r))); };
    const auto above = std::upper_bound(positions.begin() + 1, positions.end(), r);
    std::size_t k = std::max<std::size_t>(above - positions.begin() - 1, 1);
    double at_begin = primitive(std::max(positions[k], r));
    for (; k + 1 < n; ++k) {
        const double at_end = primitive(positions[k + 1]);
        const double slope = (line_load[k + 1] - line_load[k]) / (positions[k + 1] - positions[k]);
        sum += slope * (at_end - at_begin);
        at_begin = at_end;
    }
    return -sum / std::numbers::pi;
}

}  // namespace tricontact::mdr
