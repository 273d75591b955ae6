#include "io/results/vtk_indenter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/results/vtk_xml.h"

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

VtkFile IndenterShape::file(const Place& place, const Provenance& provenance) const {
    const double cos = std::cos(place.rotation), sin = std::sin(place.rotation);
    Points places;
    for (const auto& [x, y, height] : points_)
        places.push_back({place.offset[0] + x * cos - y * sin, place.offset[1] + x * sin + y * cos,
                          height - place.indentation});
    const int n_across = static_cast<int>(points_.size()) / n_along_;
    const std::string extent = fmt::format("0 {} 0 {} 0 0", n_along_ - 1, n_across - 1);
    VtkXml xml("StructuredGrid", {{"WholeExtent", extent}}, Compression::quick);
    xml.begin("FieldData");
    xml.add_provenance(provenance);
    xml.end();
    xml.begin("Piece", {{"Extent", extent}});
    xml.add_points(places);
    return xml.file();
}

}  // namespace tricontact::io
