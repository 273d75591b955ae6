#include "meshes/hex_mesh.h"

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"

namespace tricontact::meshes {

namespace {

// Corner c sits at x = 1 if bit 0 is set, and so on: gmsh goes around, a cube counts in binary.
constexpr std::array<int, 8> cube_corner{0, 1, 3, 2, 4, 5, 7, 6};

// Edge vectors along direction d, interpolated to (s, t) in the two other, cyclic directions.
Point tangent(const std::array<Point, 8>& corners, int d, double s, double t) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    Point sum{};
    for (int k = 0; k < 4; ++k) {
        const int low = ((k & 1) << e) | ((k >> 1) << f), high = low | (1 << d);
        const double weight = ((k & 1) != 0 ? s : 1 - s) * ((k >> 1) != 0 ? t : 1 - t);
        const Point edge = difference(corners[cube_corner[high]], corners[cube_corner[low]]);
        for (int i = 0; i < 3; ++i) sum[i] += weight * edge[i];
    }
    return sum;
}

double distance_to_triangle_plane(const Point& normal, const Point& a, const Point& p) {
    const double length = std::sqrt(dot(normal, normal));
    return length > 0 ? std::abs(dot(difference(p, a), normal)) / length : contact::infinity;
}

bool triangle_covers(const Point& a, const Point& b, const Point& c, const Point& p,
                     double tolerance) {
    const Point normal = cross(difference(b, a), difference(c, a));
    if (!(distance_to_triangle_plane(normal, a, p) <= tolerance)) return false;
    const double length = std::sqrt(dot(normal, normal));
    auto inside = [&](const Point& from, const Point& to) {
        const Point edge = difference(to, from);
        const double area = dot(cross(edge, difference(p, from)), normal) / length;
        return area >= -tolerance * std::sqrt(dot(edge, edge));
    };
    return inside(a, b) && inside(b, c) && inside(c, a);
}

// Knupp (2000): Jacobian matrix norm and scaled Jacobian at the corners.
double scaled_jacobian(const std::array<Point, 8>& corners) {
    double least = contact::infinity;
    for (int c = 0; c < 8; ++c) {
        std::array<Point, 3> edges;
        double box = 1;
        for (int i = 0; i < 3; ++i) {
            const Point& end = corners[hex_neighbours[c][i]];
            edges[i] = difference(end, corners[c]);
            box *= distance(end, corners[c]);
        }
        least = std::min(least, dot(cross(edges[0], edges[1]), edges[2]) / box);
    }
    return least;
}

void measure_contact(const HexMesh& mesh, MeshQuality& quality) {
    for (const HexMesh::Face& face : mesh.faces) {
        if (face.boundary != Boundary::contact) continue;
        ++quality.n_contact_faces;
        for (int i = 0; i < 4; ++i)
            quality.contact_size =
                std::max(quality.contact_size,
                         distance(mesh.nodes[face.nodes[i]], mesh.nodes[face.nodes[(i + 1) % 4]]));
    }
}

void measure_box(const HexMesh& mesh, MeshQuality& quality) {
    if (mesh.nodes.empty()) return;
    quality.low = quality.high = mesh.nodes.front();
    for (const auto& node : mesh.nodes)
        for (int d = 0; d < 3; ++d) {
            quality.low[d] = std::min(quality.low[d], node[d]);
            quality.high[d] = std::max(quality.high[d], node[d]);
        }
}

// Four values: a network of comparisons is faster than a general sort.
std::array<int, 4> sorted(std::array<int, 4> v) {
    auto order = [&](int i, int j) {
        if (v[j] < v[i]) std::swap(v[i], v[j]);
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
    return v;
}

}  // namespace

const char* name_of(Boundary boundary) {
    static constexpr std::array<const char*, n_boundaries> names{"contact", "free_top", "base",
                                                                 "sides", "symmetry"};
    return names.at(static_cast<std::size_t>(boundary));
}

const char* name_of(Region region) {
    static constexpr std::array<const char*, n_regions> names{"layer", "lower_layer"};
    return names.at(static_cast<std::size_t>(region));
}

Point difference(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double distance(const Point& a, const Point& b) {
    const Point d = difference(a, b);
    return std::sqrt(dot(d, d));
}

std::array<Point, 8> corners_of(const HexMesh& mesh, const std::array<int, 8>& hex) {
    std::array<Point, 8> corners;
    std::transform(hex.begin(), hex.end(), corners.begin(),
                   [&](int node) { return mesh.nodes[node]; });
    return corners;
}

EdgeLengths edge_lengths(const std::array<Point, 8>& corners) {
    EdgeLengths lengths{contact::infinity, 0};
    for (int c = 0; c < 8; ++c)
        for (const int neighbour : hex_neighbours[c]) {
            const double edge = distance(corners[c], corners[neighbour]);
            lengths = {std::min(lengths.shortest, edge), std::max(lengths.longest, edge)};
        }
    return lengths;
}

double least_jacobian(const std::array<Point, 8>& corners) {
    // The tangent along one direction depends on the two others only: 9 values each.
    std::array<std::array<std::array<Point, 3>, 3>, 3> tangents;
    for (int d = 0; d < 3; ++d)
        for (int s = 0; s < 3; ++s)
            for (int t = 0; t < 3; ++t) tangents[d][s][t] = tangent(corners, d, s / 2., t / 2.);
    double least = contact::infinity;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                const Point area = cross(tangents[0][j][k], tangents[1][k][i]);
                const double value = dot(area, tangents[2][i][j]);
                if (value < least || std::isnan(value)) least = value;  // a NaN stays
            }
    return least;
}

bool covers(const std::array<Point, 4>& corners, const Point& point, double tolerance) {
    const auto& [a, b, c, d] = corners;
    return triangle_covers(a, b, c, point, tolerance) || triangle_covers(a, c, d, point, tolerance);
}

MeshQuality quality(const HexMesh& mesh) {
    MeshQuality quality;
    quality.n_nodes = mesh.nodes.size();
    quality.n_hexes = mesh.hexes.size();
    if (!mesh.hexes.empty()) quality.least_jacobian = contact::infinity;
    for (const auto& hex : mesh.hexes) {
        const std::array<Point, 8> corners = corners_of(mesh, hex);
        quality.least_jacobian = std::min(quality.least_jacobian, scaled_jacobian(corners));
        const auto [shortest, longest] = edge_lengths(corners);
        quality.largest_aspect_ratio = std::max(quality.largest_aspect_ratio, longest / shortest);
    }
    measure_contact(mesh, quality);
    measure_box(mesh, quality);
    return quality;
}

FaceTable::FaceTable(const HexMesh& mesh) {
    sides_.reserve(6 * mesh.hexes.size());
    for (std::size_t e = 0; e < mesh.hexes.size(); ++e)
        for (int f = 0; f < 6; ++f) {
            std::array<int, 4> nodes{};
            for (int i = 0; i < 4; ++i) nodes[i] = mesh.hexes[e][hex_faces[f][i]];
            sides_.push_back({sorted(nodes), static_cast<int>(e), f});
        }
    std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
        return a.key != b.key ? a.key < b.key : a.hex < b.hex;
    });
    for (std::size_t i = 0; i < sides_.size(); ++i)
        if (i == 0 || sides_[i].key != sides_[i - 1].key) begin_.push_back(i);
    begin_.push_back(sides_.size());
}

std::size_t FaceTable::find(std::array<int, 4> nodes) const {
    const std::array<int, 4> key = sorted(nodes);
    const auto groups = std::span(begin_).first(n_faces());
    const auto at = std::lower_bound(
        groups.begin(), groups.end(), key,
        [&](std::size_t begin, const std::array<int, 4>& k) { return sides_[begin].key < k; });
    if (at == groups.end() || sides_[*at].key != key) return n_faces();
    return static_cast<std::size_t>(at - groups.begin());
}

}  // namespace tricontact::meshes
