#include "benchmarks/submissions/surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

using Vector = std::array<double, 3>;

double dot_of(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool is_flat(const MeshData& mesh) {
    double far = 0;
    for (const Vector& p : mesh.points) far = std::max({far, std::abs(p[0]), std::abs(p[1])});
    return std::ranges::all_of(mesh.points, [&](const Vector& p) {
        return std::abs(p[2] - mesh.points[0][2]) <= 1e-9 * far;
    });
}

Vector mean_normal(const std::vector<MeshFace>& faces, const std::vector<std::size_t>& some_faces) {
    Vector sum{};
    for (const std::size_t f : some_faces)
        for (std::size_t k = 0; k < 3; ++k) sum[k] += faces[f].normal[k] * faces[f].size;
    const double length = std::sqrt(dot_of(sum, sum));
    for (double& component : sum) component = length > 0 ? component / length : 0;
    return sum;
}

/// Faces all of whose corners carry load, else those of most.
std::vector<std::size_t> seeds(const std::vector<MeshFace>& faces,
                               const std::vector<bool>& is_loaded) {
    std::vector<std::size_t> found;
    int most = 1;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        int n = 0;
        for (int k = 0; k < faces[f].n_corners; ++k)
            if (is_loaded[static_cast<std::size_t>(faces[f].points[static_cast<std::size_t>(k)])])
                ++n;
        const int score = n == faces[f].n_corners ? 100 : n;
        if (score < most) continue;
        if (score > most) found.clear();
        most = score;
        found.push_back(f);
    }
    return found;
}

/// Faces at the greatest z, of plane meshes y.
std::vector<std::size_t> highest(const std::vector<MeshFace>& faces, std::size_t axis) {
    double top = -INFINITY, size = 0;
    for (const MeshFace& face : faces) top = std::max(top, face.centre[axis]);
    for (const MeshFace& face : faces) size = std::max(size, face.size);
    std::vector<std::size_t> found;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (faces[f].centre[axis] > top - 1e-6 * std::sqrt(size) &&
            std::abs(faces[f].normal[axis]) > .9)
            found.push_back(f);
    return found;
}

/// With the faces that continue them over a common edge (of lines: point): bent against the face
/// before by less than 20 degrees and against the mean by less than 45.
std::vector<std::size_t> continued(const std::vector<MeshFace>& faces,
                                   std::vector<std::size_t> found,
                                   const std::vector<int>& same_point) {
    const Vector mean = mean_normal(faces, found);
    std::map<std::array<int, 2>, std::vector<std::size_t>> at_edge;
    const auto edges = [&](const MeshFace& face) {
        std::vector<std::array<int, 2>> result;
        const auto n = static_cast<std::size_t>(face.n_corners);
        const auto node = [&](std::size_t k) {
            return same_point[static_cast<std::size_t>(face.points[k % n])];
        };
        for (std::size_t k = 0; k < n; ++k)
            result.push_back(n == 2 ? std::array{node(k), node(k)}
                                    : std::array{std::min(node(k), node(k + 1)),
                                                 std::max(node(k), node(k + 1))});
        return result;
    };
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (dot_of(faces[f].normal, mean) > std::cos(.785398))
            for (const auto& edge : edges(faces[f])) at_edge[edge].push_back(f);
    std::vector<bool> taken(faces.size(), false);
    for (const std::size_t f : found) taken[f] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const auto& edge : edges(faces[found[i]]))
            for (const std::size_t next : at_edge[edge])
                if (!taken[next] && dot_of(faces[next].normal, faces[found[i]].normal) > .94) {
                    taken[next] = true;
                    found.push_back(next);
                }
    std::ranges::sort(found);
    return found;
}

/// Whether points that are on no face of the boundary carry load.
bool some_within(const MeshData& mesh, const std::vector<bool>& is_loaded,
                 const std::vector<MeshFace>& faces) {
    // Of points in the same place one is on the face.
    const auto same = first_of_same_place(mesh);
    std::vector<bool> is_there(mesh.points.size(), false);
    for (const MeshFace& face : faces)
        for (const int p : face.points)
            is_there[static_cast<std::size_t>(same[static_cast<std::size_t>(p)])] = true;
    for (std::size_t i = 0; i < is_loaded.size(); ++i)
        if (is_loaded[i] && !is_there[static_cast<std::size_t>(same[i])]) return true;
    return false;
}

Surface of_body(const MeshData& mesh, const std::vector<bool>& is_loaded,
                const std::string& place) {
    std::vector<int> own(mesh.points.size());
    std::iota(own.begin(), own.end(), 0);
    std::size_t n_inner = 0;
    std::vector<MeshFace> faces = boundary_faces(mesh, own, n_inner);
    // Some programs write the points of each cell for itself.
    if (mesh.has_pieces || (n_inner == 0 && mesh.n_cells() > 1)) {
        own = first_of_same_place(mesh);
        faces = boundary_faces(mesh, own, n_inner);
    }
    Surface surface{.is_plane = dimension_of(mesh) == 2};
    const std::size_t up = surface.is_plane ? 1 : 2;
    const bool is_within = some_within(mesh, is_loaded, faces);
    const bool has_load = !is_within && std::ranges::count(is_loaded, true) > 0;
    std::vector<std::size_t> found = has_load ? seeds(faces, is_loaded) : highest(faces, up);
    if (found.empty())
        io::fail(place, "", "no face of the boundary carries a contact pressure",
                 "write the contact surface with its pressures, or a table of columns");
    surface.how = has_load ? "the boundary where contact values are not zero, and what continues it"
                  : is_within
                      ? "the highest faces of the boundary: values are not zero within the body"
                      : "the highest faces of the boundary: no contact value is given";
    found = continued(faces, std::move(found), own);
    surface.normal = mean_normal(faces, found);
    for (const std::size_t f : found) surface.faces.push_back(faces[f]);
    for (MeshFace& face : surface.faces)
        for (int& point : face.points) point = own[static_cast<std::size_t>(point)];
    return surface;
}

/// A flat mesh of areas is a body of a plane or axisymmetric model where only its edge carries
/// load, else the surface itself.
bool is_body(const MeshData& mesh, const std::vector<bool>& is_loaded) {
    const int dimension = dimension_of(mesh);
    if (dimension == 3 || mesh.is_axisymmetric) return true;
    if (dimension < 2 || !is_flat(mesh)) return false;
    const bool has_load = std::ranges::count(is_loaded, true) > 0;
    if (!has_load) return !mesh.point_arrays.empty();
    const std::vector<bool> is_rim = points_of_boundary(mesh);
    for (std::size_t i = 0; i < is_loaded.size(); ++i)
        if (is_loaded[i] && !is_rim[i]) return false;
    return true;
}

}  // namespace

Surface find_surface(const MeshData& mesh, const std::vector<bool>& is_loaded,
                     const std::string& place) {
    if (is_body(mesh, is_loaded)) return of_body(mesh, is_loaded, place);
    Surface surface{.how = "the cells of the file"};
    if (dimension_of(mesh) > 0) surface.faces = cells_as_faces(mesh);
    surface.is_plane = dimension_of(mesh) == 1;
    std::vector<std::size_t> all(surface.faces.size());
    std::iota(all.begin(), all.end(), 0U);
    surface.normal = surface.is_plane        ? Vector{0, 1, 0}
                     : surface.faces.empty() ? Vector{0, 0, 1}
                                             : mean_normal(surface.faces, all);
    return surface;
}

std::string axes_of(const Surface& surface) {
    const auto size = [&](std::size_t k) { return std::abs(surface.normal[k]); };
    if (surface.is_plane) return size(0) > size(1) ? "zxy" : "xzy";
    if (size(2) >= size(0) && size(2) >= size(1)) return "xyz";
    return size(1) >= size(0) ? "xzy" : "zyx";
}

}  // namespace tricontact::benchmarks
