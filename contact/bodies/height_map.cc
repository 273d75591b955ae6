#include "contact/bodies/height_map.h"

#include <algorithm>
#include <cmath>

#include "contact/base/error.h"
#include "contact/base/special_values.h"

namespace tricontact::contact {

namespace {

HeightMap checked(HeightMap map) {
    const bool whole = map.n_x >= 2 && map.n_y >= 2 &&
                       map.height.size() == static_cast<std::size_t>(map.n_x) * map.n_y;
    if (!whole) throw InputError("height map: there must be 2 x 2 heights at least");
    for (const double h : map.spacing)
        if (!is_positive_and_finite(h))
            throw InputError("height map: the spacing must be positive and finite");
    if (!std::ranges::all_of(map.height, [](double z) { return std::isfinite(z); }))
        throw InputError("height map: all heights must be finite");
    return map;
}

/// Node below `x` (in spacings) on a lattice of n nodes that repeats itself, and the way from it.
std::pair<int, double> node_below(double x, int n) {
    // What is a node but for the rounding of a quotient is that node: maps and cells of one spacing
    // meet exactly.
    constexpr double rounding = 1e-9;
    double below = std::floor(x), way = x - below;
    if (way > 1 - rounding) {
        below += 1;
        way = 0;
    }
    const double wrapped = below - n * std::floor(below / n);
    return {static_cast<int>(wrapped) % n, way < rounding ? 0 : way};
}

}  // namespace

HeightField::HeightField(HeightMap map) : map_(checked(std::move(map))) {}

HeightField::Place HeightField::at(double x, double y) const {
    const auto [i, right] = node_below(x / map_.spacing[0], map_.n_x);
    const auto [j, up] = node_below(y / map_.spacing[1], map_.n_y);
    const int next_i = i + 1 == map_.n_x ? 0 : i + 1, next_j = j + 1 == map_.n_y ? 0 : j + 1;
    const double low_low = map_.at(i, j), high_low = map_.at(next_i, j);
    const double low_high = map_.at(i, next_j), high_high = map_.at(next_i, next_j);
    const double along_low = high_low - low_low, along_high = high_high - low_high;
    const double across_low = low_high - low_low, across_high = high_high - high_low;
    const double low = low_low + right * along_low, high = low_high + right * along_high;
    return {low + up * (high - low),
            {(along_low + up * (along_high - along_low)) / map_.spacing[0],
             (across_low + right * (across_high - across_low)) / map_.spacing[1]}};
}

double rms_height(const HeightMap& map) {
    double mean = 0, square = 0;
    for (const double z : map.height) mean += z;
    mean /= static_cast<double>(map.height.size());
    for (const double z : map.height) square += (z - mean) * (z - mean);
    return std::sqrt(square / static_cast<double>(map.height.size()));
}

double rms_slope(const HeightMap& map) {
    double along = 0, across = 0;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i + 1 < map.n_x; ++i)
            along += std::pow((map.at(i + 1, j) - map.at(i, j)) / map.spacing[0], 2);
    for (int j = 0; j + 1 < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            across += std::pow((map.at(i, j + 1) - map.at(i, j)) / map.spacing[1], 2);
    return std::sqrt(along / (map.n_x - 1.) / map.n_y + across / map.n_x / (map.n_y - 1.));
}

RoughIndenter::RoughIndenter(std::unique_ptr<const Indenter> body, HeightMap roughness)
    : body_(std::move(body)), roughness_(std::move(roughness)), lowest_(find_lowest()) {}

/// Ring by ring of nodes around the origin, until the body alone lies higher than what was found
/// plus the deepest roughness, or a whole period has been seen: bodies rise outwards.
double RoughIndenter::find_lowest() const {
    const HeightMap& map = roughness_.map();
    const double deepest = *std::ranges::min_element(map.height);
    const int rings = std::max(map.n_x, map.n_y) / 2 + 1;
    double lowest = infinity;
    for (int ring = 0; ring <= rings; ++ring) {
        double body_lowest = infinity;
        auto look = [&](int i, int j) {
            const double x = i * map.spacing[0], y = j * map.spacing[1];
            const double body = body_->height(x, y);
            body_lowest = std::min(body_lowest, body);
            lowest = std::min(lowest, body + roughness_.at(x, y).height);
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
    lowest_point_ = find_lowest_point();
}

Vector2 MappedIndenter::find_lowest_point() const {
    const HeightMap& m = field_.map();
    constexpr double rounding = 1e-12;  // of what the heights are made of: level and size
    const double equal = rounding * (std::abs(lowest_) + std::min(m.spacing[0], m.spacing[1]));
    Vector2 sum{};
    int n = 0;
    for (int j = 0; j < m.n_y; ++j)
        for (int i = 0; i < m.n_x; ++i) {
            if (m.at(i, j) - lowest_ > equal) continue;
            sum = sum + Vector2{static_cast<double>(i), static_cast<double>(j)};
            ++n;
        }
    return {first_[0] + sum[0] / n * m.spacing[0], first_[1] + sum[1] / n * m.spacing[1]};
}

double MappedIndenter::height(double x, double y) const {
    const Vector2 h = field_.map().spacing;
    constexpr double rounding = 1e-9;  // in spacings
    const bool inside = x >= first_[0] - rounding * h[0] && x <= last_[0] + rounding * h[0] &&
                        y >= first_[1] - rounding * h[1] && y <= last_[1] + rounding * h[1];
    if (!inside) return infinity;
    return field_.at(x - first_[0], y - first_[1]).height - lowest_;
}

HeightMap from_middle(const HeightMap& map) {
    HeightMap moved = map;
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            moved.at(i, j) = map.at((i + map.n_x / 2) % map.n_x, (j + map.n_y / 2) % map.n_y);
    return moved;
}

}  // namespace tricontact::contact
