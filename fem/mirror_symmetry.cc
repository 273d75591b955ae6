#include "fem/mirror_symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

// A body that a plane x = const mirrors has even and odd displacements that do not couple: two
// problems on half of the mesh with one pattern (body_parts.h). A factor grows faster than the
// number of unknowns in three dimensions, its work with the square: two halves take less memory and
// time than the whole.
//
// Symmetry is looked for in the mesh, not in the case: generated meshes and those from a file
// alike. Images are found by sorting nodes by |x - middle|, y and z in units far above rounding.

namespace tricontact::fem {

namespace {

using Point = std::array<double, 3>;

// Of the body's extent along x: thousands of roundings of a coordinate, and less of an element than
// a factor's own rounding makes of the compliance.
constexpr double mirror_rounding = 1e-12;

constexpr int centre_of_face = 8;  // no other face has that node

// The plane x = middle, which is the only one that can mirror the nodes.
struct Plane {
    double middle, tolerance;  // [m]

    explicit Plane(const std::vector<Point>& nodes) {
        const auto [low, high] =
            std::ranges::minmax(nodes, {}, [](const Point& x) { return x[0]; });
        middle = (low[0] + high[0]) / 2;
        tolerance = mirror_rounding * (high[0] - low[0]);
    }
    std::int8_t side(const Point& x) const {
        const double distance = x[0] - middle;
        return static_cast<std::int8_t>((distance > tolerance) - (distance < -tolerance));
    }
    bool mirrors(const Point& x, const Point& image) const {
        return std::abs(x[0] + image[0] - 2 * middle) <= 2 * tolerance &&
               std::abs(x[1] - image[1]) <= tolerance && std::abs(x[2] - image[2]) <= tolerance;
    }
};

// Images have the same place in units far above rounding and far below any element, in which no
// round length lies between two.
bool find_images(const std::vector<Point>& nodes, const Plane& plane, MirrorSymmetry& mirror) {
    struct Place {
        std::array<long long, 3> at;  // distance from the plane, y, z
        int side, node;
    };
    std::vector<Place> places;
    const double unit = 1e4 * std::numbers::pi * plane.tolerance;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Point& x = nodes[i];
        mirror.side.push_back(plane.side(x));
        places.push_back({{std::llround(std::abs(x[0] - plane.middle) / unit),
                           std::llround(x[1] / unit), std::llround(x[2] / unit)},
                          mirror.side.back(),
                          static_cast<int>(i)});
    }
    std::ranges::sort(places, [](const Place& a, const Place& b) {
        return a.at != b.at ? a.at < b.at : a.side < b.side;
    });
    mirror.image.assign(nodes.size(), -1);
    for (std::size_t k = 0; k < places.size();) {
        const Place& place = places[k];
        const std::size_t n = place.side == 0 ? 1 : 2;  // nodes at that place
        if (k + n > places.size()) return false;
        const Place& image = places[k + n - 1];
        if (image.side != -place.side || !plane.mirrors(nodes[place.node], nodes[image.node]))
            return false;
        mirror.image[place.node] = image.node;
        mirror.image[image.node] = place.node;
        k += n;
    }
    return true;
}

bool find_half(const Q2Space& space, MirrorSymmetry& mirror) {
    std::vector<int> cell_about(space.nodes.size(), -1);
    for (std::size_t c = 0; c < space.cells.size(); ++c)
        cell_about[space.cells[c][centre_of_cell]] = static_cast<int>(c);
    for (std::size_t c = 0; c < space.cells.size(); ++c) {
        auto nodes = space.cells[c];
        const int side = mirror.side[nodes[centre_of_cell]];
        const auto is_across = [&](int node) { return mirror.side[node] * side < 0; };
        if (side == 0 || std::ranges::any_of(nodes, is_across)) return false;
        if (side > 0) mirror.half.push_back(static_cast<int>(c));
        const int other = cell_about[mirror.image[nodes[centre_of_cell]]];
        if (other < 0 || space.regions[other] != space.regions[c]) return false;
        auto others = space.cells[other];
        for (int& node : nodes) node = mirror.image[node];
        std::ranges::sort(nodes);
        std::ranges::sort(others);
        if (nodes != others) return false;
    }
    return true;
}

bool names_are_mirrored(const Q2Space& space, const MirrorSymmetry& mirror) {
    std::vector<int> face_about(space.nodes.size(), -1);
    for (std::size_t f = 0; f < space.faces.size(); ++f)
        face_about[space.faces[f].nodes[centre_of_face]] = static_cast<int>(f);
    return std::ranges::all_of(space.faces, [&](const Q2Space::Face& face) {
        const int other = face_about[mirror.image[face.nodes[centre_of_face]]];
        return other >= 0 && space.faces[other].boundary == face.boundary;
    });
}

}  // namespace

std::optional<MirrorSymmetry> mirror_symmetry(const Q2Space& space) {
    MirrorSymmetry mirror;
    if (find_images(space.nodes, Plane(space.nodes), mirror) && find_half(space, mirror) &&
        names_are_mirrored(space, mirror))
        return mirror;
    return std::nullopt;
}

}  // namespace tricontact::fem
