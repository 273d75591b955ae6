#include "benchmarks/submissions/plane_slice.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "benchmarks/submissions/mesh_cells.h"

namespace tricontact::benchmarks {

namespace {

using Vector = std::array<double, 3>;
constexpr double degree = std::numbers::pi / 180;

double farthest(const MeshData& mesh) {
    double far = 0;
    for (const Vector& p : mesh.points) far = std::max(far, std::hypot(p[0], p[2]));
    return far;
}

/// Coordinates have six digits.
constexpr double coarse = 1e-5;

/// One face of each volume, all of whose points the predicate wants.
MeshData faces_of_volumes(const MeshData& mesh, const std::function<bool(const Vector&)>& wanted,
                          const std::function<bool(const Vector&)>& counts) {
    MeshData plane{.name = mesh.name, .points = mesh.points, .point_arrays = mesh.point_arrays};
    for (const MeshFace& face : all_faces(mesh)) {
        bool all = true, some = false;
        for (const int p : face.points) {
            const Vector& at = mesh.points[static_cast<std::size_t>(p)];
            all = all && wanted(at);
            some = some || counts(at);
        }
        if (!all || !some) continue;
        const bool has_middles = face.points.size() > static_cast<std::size_t>(face.n_corners);
        plane.types.push_back(face.n_corners == 4 ? (has_middles ? 23 : 9) : has_middles ? 22 : 5);
        plane.connectivity.insert(plane.connectivity.end(), face.points.begin(), face.points.end());
        plane.offsets.push_back(static_cast<std::int64_t>(plane.connectivity.size()));
    }
    keep_used_points(plane);
    return plane;
}

/// Components at a point in the axes along r and across it.
void turn(MeshArray& array, std::size_t i, double c, double s) {
    const auto n = static_cast<std::size_t>(array.n_components);
    double* const v = array.values.data() + i * n;
    if (n == 3) {
        const double along = c * v[0] + s * v[2], across = -s * v[0] + c * v[2];
        v[0] = along;
        v[2] = across;
    } else if (n == 6) {  // xx yy zz xy yz xz
        const double xx = v[0], zz = v[2], xy = v[3], yz = v[4], xz = v[5];
        v[0] = c * c * xx + s * s * zz + 2 * c * s * xz;
        v[2] = s * s * xx + c * c * zz - 2 * c * s * xz;
        v[3] = c * xy + s * yz;
        v[4] = c * yz - s * xy;
        v[5] = (c * c - s * s) * xz + c * s * (zz - xx);
    }
}

}  // namespace

bool is_wedge_of_two_degrees(const std::vector<MeshData>& meshes) {
    bool some = false;
    for (const MeshData& mesh : meshes) {
        if (dimension_of(mesh) != 3) return false;
        const double far = farthest(mesh);
        for (const int node : mesh.connectivity) {
            const Vector& p = mesh.points[static_cast<std::size_t>(node)];
            const double r = std::hypot(p[0], p[2]);
            if (r < coarse * far) continue;
            const double angle = std::abs(std::atan2(p[2], p[0])) / degree;
            const double slack = coarse * far / r / degree + 1e-3;
            if (std::min(angle, std::abs(angle - 1)) > slack) return false;
            if (std::abs(angle - 1) <= slack) some = true;
        }
    }
    return some;
}

MeshData collapsed_wedge(const MeshData& mesh) {
    const double far = farthest(mesh);
    const auto is_at_axis = [&](const Vector& p) { return std::hypot(p[0], p[2]) < coarse * far; };
    const auto is_at_one = [&](const Vector& p) {
        return p[2] > .5 * std::hypot(p[0], p[2]) * std::sin(degree);
    };
    MeshData plane = faces_of_volumes(
        mesh, [&](const Vector& p) { return is_at_axis(p) || is_at_one(p); },
        [&](const Vector& p) { return !is_at_axis(p) && is_at_one(p); });
    plane.is_axisymmetric = true;
    for (std::size_t i = 0; i < plane.points.size(); ++i) {
        Vector& p = plane.points[i];
        const double r = std::hypot(p[0], p[2]);
        if (is_at_one(p) && r > 0)
            for (MeshArray& array : plane.point_arrays) turn(array, i, p[0] / r, p[2] / r);
        p = {r, p[1], 0};
    }
    return plane;
}

void flatten(MeshData& mesh) {
    if (dimension_of(mesh) != 2) return;
    const double rest = std::cos(std::numbers::pi / 2);
    bool some = false;
    for (const Vector& p : mesh.points) {
        if (std::abs(p[2] - rest * p[0]) > 1e-4 * rest * std::abs(p[0])) return;
        some = some || p[2] != 0;
    }
    mesh.is_axisymmetric = mesh.is_axisymmetric || some;
    for (Vector& p : mesh.points) p[2] = 0;
}

std::optional<MeshData> collapsed_slice(const MeshData& mesh) {
    if (dimension_of(mesh) != 3) return {};
    double low = INFINITY, high = -INFINITY;
    for (const int node : mesh.connectivity) {
        low = std::min(low, mesh.points[static_cast<std::size_t>(node)][2]);
        high = std::max(high, mesh.points[static_cast<std::size_t>(node)][2]);
    }
    const double slack = coarse * (high - low);
    if (!(slack > 0)) return {};
    // Corners of one layer of elements stand at the two planes, middle nodes halfway.
    for (const int node : mesh.connectivity) {
        const double z = mesh.points[static_cast<std::size_t>(node)][2];
        if (std::min({z - low, high - z, std::abs(z - (low + high) / 2)}) > slack) return {};
    }
    const auto is_high = [&](const Vector& p) { return p[2] > high - slack; };
    MeshData plane = faces_of_volumes(mesh, is_high, is_high);
    if (plane.n_cells() != mesh.n_cells()) return {};
    const auto pressures = std::ranges::find(plane.point_arrays, "CPRESS", &MeshArray::name);
    if (pressures == plane.point_arrays.end()) return {};
    const std::vector<bool> is_rim = points_of_boundary(plane);
    for (const int node : plane.connectivity)
        if (pressures->values[static_cast<std::size_t>(node)] != 0 &&
            !is_rim[static_cast<std::size_t>(node)])
            return {};  // a layer of one element, pressed from above
    return plane;
}

}  // namespace tricontact::benchmarks
