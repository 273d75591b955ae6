#include "io/results/vtk_indenter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tricontact::io {

namespace {

constexpr int n_radial = 16, n_around = 48, n_across = 32;

using Points = std::vector<std::array<double, 3>>;

Points points_of(const contact::Indenter& indenter, double radius, double half_length) {
    Points points;
    const auto add = [&](double x, double y) { points.push_back({x, y, indenter.height(x, y)}); };
    if (half_length > 0) {
        for (const double y : {-half_length, half_length})
            for (int i = 0; i <= n_across; ++i) add(radius * (2. * i / n_across - 1), y);
        return points;
    }
    for (int j = 0; j <= n_around; ++j)
        for (int i = 0; i <= n_radial; ++i) {
            const double r = radius * i / n_radial;
            const double angle = 2 * std::numbers::pi * (j % n_around) / n_around;
            add(r * std::cos(angle), r * std::sin(angle));
        }
    return points;
}

bool is_finite(const Points& points) {
    return std::ranges::all_of(points, [](const auto& p) { return std::isfinite(p[2]); });
}

}  // namespace

IndenterShape::IndenterShape(const contact::Indenter& indenter, const Extent& extent)
    : n_along_(extent.half_length > 0 ? n_across + 1 : n_radial + 1) {
    double radius = extent.radius, half_length = extent.half_length;
    points_ = points_of(indenter, radius, half_length);
    constexpr int most_tries = 100;
    for (int tries = 0; !is_finite(points_) && tries < most_tries; ++tries) {
        radius *= 0.95;
        half_length *= 0.95;
        points_ = points_of(indenter, radius, half_length);
    }
}

ExodusMesh IndenterShape::mesh() const {
    ExodusBlock block{.name = "indenter", .element = "QUAD4", .nodes_per_element = 4};
    const int n_across = static_cast<int>(points_.size()) / n_along_;
    for (int j = 0; j + 1 < n_across; ++j)
        for (int i = 0; i + 1 < n_along_; ++i) {
            const int corner = j * n_along_ + i + 1;
            block.nodes.insert(block.nodes.end(),
                               {corner, corner + 1, corner + n_along_ + 1, corner + n_along_});
        }
    return {.points = points_, .blocks = {std::move(block)}};
}

ExodusFields IndenterShape::moved(const Place& place, const Instant& instant) const {
    const double cos = std::cos(place.rotation), sin = std::sin(place.rotation);
    std::array<std::vector<double>, 3> moved;
    for (const auto& [x, y, height] : points_) {
        moved[0].push_back(place.offset[0] + x * cos - y * sin - x);
        moved[1].push_back(place.offset[1] + x * sin + y * cos - y);
        moved[2].push_back(-place.indentation);
    }
    ExodusFields fields;
    fields.add_number(instant.name, instant.time);
    constexpr std::array names{"displacement_m_x", "displacement_m_y", "displacement_m_z"};
    for (std::size_t d = 0; d < 3; ++d) fields.add_scalar(names.at(d), moved.at(d), points_.size());
    return fields;
}

}  // namespace tricontact::io
