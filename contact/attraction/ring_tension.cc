#include "contact/attraction/ring_tension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/gauss_legendre.h"

namespace tricontact::contact {

namespace {

// Exact for the smooth law, a polynomial of the fourth degree, times radius and weight of a point.
constexpr int points_of_gap = 4;

/// The part [low, high] of [0, 1] in which a gap that goes from `first` to `last` is less than
/// `end`.
std::array<double, 2> part_below(double first, double last, double end) {
    if (first < end && last < end) return {0, 1};
    if (!(first < end || last < end)) return {0, 0};
    const double at = (end - first) / (last - first);
    return first < end ? std::array{0., at} : std::array{at, 1.};
}

}  // namespace

/// `add` takes the point before, that after, the share of the latter, the gap and the area of each
/// place of the rule. The disc within the first point has its gap.
template <class Add>
void RingTension::integrate(const Attraction& law, std::span<const double> gap,
                            const Add& add) const {
    const auto& r = points_.x;
    const QuadratureRule& rule = gauss_legendre(points_of_gap);
    const double inner = r[0];
    add(0, 0, 0., gap[0], std::numbers::pi * inner * inner);
    for (std::size_t i = 0; i + 1 < r.size(); ++i) {
        const double first = gap[i], last = gap[i + 1];
        if (!std::isfinite(first) || !std::isfinite(last)) continue;
        const auto [low, high] =
            law.decays ? std::array{0., 1.} : part_below(first, last, law.distance);
        for (int k = 0; k < points_of_gap; ++k) {
            const double share = std::lerp(low, high, rule.points[k]);
            const double width = (high - low) * rule.weights[k] * (r[i + 1] - r[i]);
            add(i, i + 1, share, std::lerp(first, last, share),
                2 * std::numbers::pi * std::lerp(r[i], r[i + 1], share) * width);
        }
    }
}

void RingTension::tensions(const Attraction& law, std::span<const double> gap,
                           std::span<double> tension) const {
    std::ranges::fill(tension, 0);
    integrate(law, gap,
              [&](std::size_t before, std::size_t after, double share, double g, double area) {
                  const double force = area * law.tension(g, 0);
                  tension[before] += (1 - share) * force;
                  tension[after] += share * force;
              });
    for (std::size_t i = 0; i < tension.size(); ++i) tension[i] /= points_.area[i];
}

double RingTension::energy(const Attraction& law, std::span<const double> gap) const {
    double sum = 0;
    integrate(law, gap, [&](std::size_t, std::size_t, double, double g, double area) {
        sum += area * law.energy(g, 0);
    });
    return sum;
}

}  // namespace tricontact::contact
