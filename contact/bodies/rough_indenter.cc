#include "contact/bodies/rough_indenter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tricontact::contact {

RoughIndenter::RoughIndenter(std::unique_ptr<const Indenter> body, HeightMap roughness)
    : body_(std::move(body)), roughness_(std::move(roughness)), lowest_(find_lowest()) {}

double RoughIndenter::height(double x, double y) const {
    return body_->height(x, y) + roughness_.height(x, y) - lowest_;
}

Vector2 RoughIndenter::slope(double x, double y) const {
    const Vector2 a = body_->slope(x, y), b = roughness_.slope(x, y);
    return {a[0] + b[0], a[1] + b[1]};
}

/// Ring by ring of nodes around the origin, until the body alone lies higher than what was found
/// plus the deepest roughness, or a whole period has been seen: bodies rise outwards.
double RoughIndenter::find_lowest() const {
    const HeightMap& map = roughness_.map();
    const double deepest = *std::ranges::min_element(map.height);
    const int rings = std::max(map.n_x, map.n_y) / 2 + 1;
    double lowest = std::numeric_limits<double>::infinity();
    for (int ring = 0; ring <= rings; ++ring) {
        double body_lowest = std::numeric_limits<double>::infinity();
        auto look = [&](int i, int j) {
            const double x = i * map.spacing[0], y = j * map.spacing[1];
            const double body = body_->height(x, y);
            body_lowest = std::min(body_lowest, body);
            lowest = std::min(lowest, body + roughness_.height(x, y));
        };
        for (int k = -ring; k <= ring; ++k) {
            look(k, -ring);
            look(k, ring);
            look(-ring, k);
            look(ring, k);
        }
        if (body_lowest + deepest >= lowest) break;
    }
    return lowest;
}

MappedIndenter::MappedIndenter(HeightMap map)
    : field_(std::move(map)), lowest_(*std::ranges::min_element(field_.map().height)) {
    const HeightMap& m = field_.map();
    first_ = {-(m.n_x / 2) * m.spacing[0], -(m.n_y / 2) * m.spacing[1]};
    last_ = {first_[0] + (m.n_x - 1) * m.spacing[0], first_[1] + (m.n_y - 1) * m.spacing[1]};
}

double MappedIndenter::height(double x, double y) const {
    const Vector2 h = field_.map().spacing;
    constexpr double rounding = 1e-9;  // in spacings
    const bool inside = x >= first_[0] - rounding * h[0] && x <= last_[0] + rounding * h[0] &&
                        y >= first_[1] - rounding * h[1] && y <= last_[1] + rounding * h[1];
    if (!inside) return std::numeric_limits<double>::infinity();
    return field_.height(x - first_[0], y - first_[1]) - lowest_;
}

Vector2 MappedIndenter::slope(double x, double y) const {
    return field_.slope(x - first_[0], y - first_[1]);
}

HeightMap from_middle(const HeightMap& map) {
    HeightMap moved = map;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            moved.height[static_cast<std::size_t>(j) * map.n_x + i] =
                map.at((i + map.n_x / 2) % map.n_x, (j + map.n_y / 2) % map.n_y);
    return moved;
}

}  // namespace tricontact::contact
