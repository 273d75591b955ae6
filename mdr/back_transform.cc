#include "mdr/back_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::mdr {

std::vector<double> abel_weights(std::span<const double> positions, double r) {
    const std::size_t n = positions.size();
    if (n < 2 || positions.front() != 0)
        throw std::domain_error("back_transform: needs two or more positions, the first one 0");
    if (!(r >= 0)) throw std::domain_error("back_transform: the radius must not be negative");
    std::vector<double> weights(n - 1, 0.0);
    if (r >= positions.back()) return weights;

    const double h = positions[1];
    if (r < h) weights[0] = 2 / h * std::sqrt((h - r) * (h + r));
    // ∫ dx/sqrt(x^2 - r^2) = log(x + sqrt(x^2 - r^2))
    auto primitive = [r](double x) { return std::log(x + std::sqrt((x - r) * (x + r))); };
    const auto above = std::upper_bound(positions.begin() + 1, positions.end(), r);
    std::size_t k = std::max<std::size_t>(above - positions.begin() - 1, 1);
    double at_begin = primitive(std::max(positions[k], r));
    for (; k + 1 < n; ++k) {
        const double at_end = primitive(positions[k + 1]);
        weights[k] = at_end - at_begin;
        at_begin = at_end;
    }
    return weights;
}

double back_transform(std::span<const double> positions, std::span<const double> line_load,
                      std::span<const double> weights) {
    if (line_load.size() != positions.size() || weights.size() + 1 != positions.size())
        throw std::domain_error("back_transform: one load per position, one weight per piece");
    double sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        sum += weights[k] * (line_load[k + 1] - line_load[k]) / (positions[k + 1] - positions[k]);
    return -sum / std::numbers::pi;
}

double back_transform(std::span<const double> positions, std::span<const double> line_load,
                      double r) {
    return back_transform(positions, line_load, abel_weights(positions, r));
}

}  // namespace tricontact::mdr
