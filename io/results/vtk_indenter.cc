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

IndenterShape::IndenterShape(const contact::Indenter& indenter, const Extent& extent) {
    ExodusMesh mesh;
    double radius = extent.radius, half_length = extent.half_length;
    mesh.points = points_of(indenter, radius, half_length);
    constexpr int most_tries = 100;
    for (int tries = 0; !is_finite(mesh.points) && tries < most_tries; ++tries) {
        radius *= 0.95;
        half_length *= 0.95;
        mesh.points = points_of(indenter, radius, half_length);
    }
    // Points of a radius, or of the strip's width.
    const int n_along = extent.half_length > 0 ? n_across + 1 : n_radial + 1;
    const int n_rows = static_cast<int>(mesh.points.size()) / n_along;
    ExodusBlock block{.name = "indenter", .element = "QUAD4", .nodes_per_element = 4};
    for (int j = 0; j + 1 < n_rows; ++j)
        for (int i = 0; i + 1 < n_along; ++i) {
            const int corner = j * n_along + i + 1;
            block.nodes.insert(block.nodes.end(),
                               {corner, corner + 1, corner + n_along + 1, corner + n_along});
        }
    mesh.blocks = {std::move(block)};
    mesh_ = std::make_shared<const ExodusMesh>(std::move(mesh));
}

void IndenterShape::begin_state(ExodusFields& fields, const Place& place,
                                const Instant& instant) const {
    const double cos = std::cos(place.rotation), sin = std::sin(place.rotation);
    const std::size_t n = mesh_->points.size();
    std::array<std::vector<double>, 3> moved;
    for (auto& component : moved) component.resize(n, -place.indentation);
    for (std::size_t i = 0; i < n; ++i) {
        const auto& [x, y, height] = mesh_->points[i];
        moved[0][i] = place.offset[0] + x * cos - y * sin - x;
        moved[1][i] = place.offset[1] + x * sin + y * cos - y;
    }
    fields.begin({});
    fields.add_number(instant.name, instant.time);
    constexpr std::array names{"displacement_m_x", "displacement_m_y", "displacement_m_z"};
    for (std::size_t d = 0; d < 3; ++d) fields.add_scalar(names.at(d), moved.at(d), n);
}

}  // namespace tricontact::io
