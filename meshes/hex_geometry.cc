#include "meshes/hex_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tricontact::meshes {

namespace {

template <std::size_t n>
Point mean(const HexMesh& mesh, const std::array<int, n>& nodes) {
    Point sum{};
    for (const int node : nodes)
        for (int d = 0; d < 3; ++d) sum[d] += mesh.nodes[node][d] / n;
    return sum;
}

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
    return length > 0 ? std::abs(dot(difference(p, a), normal)) / length
                      : std::numeric_limits<double>::infinity();
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

}  // namespace

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

double least_jacobian(const std::array<Point, 8>& corners) {
    // The tangent along one direction depends on the two others only: 9 values each.
    std::array<std::array<std::array<Point, 3>, 3>, 3> tangents;
    for (int d = 0; d < 3; ++d)
        for (int s = 0; s < 3; ++s)
            for (int t = 0; t < 3; ++t) tangents[d][s][t] = tangent(corners, d, s / 2., t / 2.);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                const Point area = cross(tangents[0][j][k], tangents[1][k][i]);
                const double value = dot(area, tangents[2][i][j]);
                if (value < least || std::isnan(value)) least = value;  // a NaN stays
            }
    return least;
}

Point centre_of(const HexMesh& mesh, const std::array<int, 8>& hex) {
    return mean(mesh, hex);
}

Point centre_of(const HexMesh& mesh, const std::array<int, 4>& face) {
    return mean(mesh, face);
}

bool covers(const std::array<Point, 4>& quadrilateral, const Point& point, double tolerance) {
    const auto& [a, b, c, d] = quadrilateral;
    return triangle_covers(a, b, c, point, tolerance) || triangle_covers(a, c, d, point, tolerance);
}

}  // namespace tricontact::meshes
