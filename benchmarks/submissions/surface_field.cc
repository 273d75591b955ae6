#include "benchmarks/submissions/surface_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "benchmarks/submissions/column_names.h"
#include "benchmarks/submissions/columns.h"
#include "benchmarks/submissions/mesh_cells.h"
#include "io/keys/messages.h"

namespace tricontact::benchmarks {

namespace {

using Vector = std::array<double, 3>;

bool is_contact(Meaning meaning) {
    return meaning >= Meaning::pressure && meaning <= Meaning::force_z;
}
bool is_stress(Meaning meaning) {
    return meaning >= Meaning::stress_zz && meaning <= Meaning::stress_yz;
}

double dot(const Vector& a, const Vector& b, int) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Indices of components whose meaning the predicate wants.
template <class Wanted>
std::vector<std::size_t> components(const MeshArray& array, Wanted wanted) {
    std::vector<std::size_t> found;
    const auto names = component_names(array.name, array.n_components);
    for (std::size_t k = 0; k < names.size(); ++k)
        if (wanted(recognised(names[k]).meaning)) found.push_back(k);
    return found;
}

template <class Wanted>
bool some(const std::vector<MeshArray>& arrays, Wanted wanted) {
    return std::ranges::any_of(
        arrays, [&](const MeshArray& array) { return !components(array, wanted).empty(); });
}

/// Items at which a contact value is above a millionth of its largest.
std::vector<bool> loaded(const std::vector<MeshArray>& arrays, std::size_t n) {
    std::vector<bool> is_loaded(n, false);
    for (const MeshArray& array : arrays)
        for (const std::size_t k : components(array, is_contact)) {
            const auto step = static_cast<std::size_t>(array.n_components);
            double largest = 0;
            for (std::size_t i = 0; i < n; ++i)
                largest = std::max(largest, std::abs(array.values[i * step + k]));
            for (std::size_t i = 0; i < n; ++i)
                if (std::abs(array.values[i * step + k]) > 1e-6 * largest) is_loaded[i] = true;
        }
    return is_loaded;
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
    const double length = std::sqrt(dot(sum, sum, 0));
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
        if (dot(faces[f].normal, mean, 0) > std::cos(.785398))
            for (const auto& edge : edges(faces[f])) at_edge[edge].push_back(f);
    std::vector<bool> taken(faces.size(), false);
    for (const std::size_t f : found) taken[f] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const auto& edge : edges(faces[found[i]]))
            for (const std::size_t next : at_edge[edge])
                if (!taken[next] && dot(faces[next].normal, faces[found[i]].normal, 0) > .94) {
                    taken[next] = true;
                    found.push_back(next);
                }
    std::ranges::sort(found);
    return found;
}

/// Letters of the file's axes: z is that of the normal.
std::string axes_of(const Vector& normal, bool is_plane) {
    const auto size = [&](std::size_t k) { return std::abs(normal[k]); };
    if (is_plane) return size(0) > size(1) ? "zxy" : "xzy";
    if (size(2) >= size(0) && size(2) >= size(1)) return "xyz";
    return size(1) >= size(0) ? "xzy" : "zyx";
}

struct Surface {
    std::vector<MeshFace> faces;
    Vector normal{};
    bool is_plane = false;  ///< of lines
    std::string how;        ///< it was found
};

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
    const bool has_load = std::ranges::count(is_loaded, true) > 0;
    std::vector<std::size_t> found = has_load ? seeds(faces, is_loaded) : highest(faces, up);
    if (found.empty())
        io::fail(place, "", "no face of the boundary carries a contact pressure",
                 "write the contact surface with its pressures, or a table of columns");
    surface.how = has_load ? "the boundary where contact values are not zero, and what continues it"
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

/// Columns of positions.
void add_positions(std::vector<RawColumn>& columns, const std::vector<Vector>& at,
                   const std::string& axes, bool is_plane, bool is_axisymmetric) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (is_plane && axes[k] == 'y') continue;
        const bool is_r = is_axisymmetric && axes[k] == 'x';
        RawColumn column{std::string(1, "xyz"[k]), std::string(1, is_r ? 'r' : axes[k]), {}, {}};
        for (const Vector& point : at) column.values.push_back(point[k]);
        columns.push_back(std::move(column));
    }
}

void add_arrays(std::vector<RawColumn>& columns, const std::vector<MeshArray>& arrays,
                const std::vector<std::size_t>& items, const std::string& axes) {
    for (const MeshArray& array : arrays) {
        const auto names = component_names(array.name, array.n_components, axes);
        const auto in_file = component_names(array.name, array.n_components);
        const auto step = static_cast<std::size_t>(array.n_components);
        for (std::size_t k = 0; k < step; ++k) {
            RawColumn column{
                array.headings.empty() ? in_file[k] : array.headings[k], names[k], {}, {}};
            for (const std::size_t item : items)
                column.values.push_back(array.values[item * step + k]);
            columns.push_back(std::move(column));
        }
    }
}

void add_points(MeshField& field, const MeshData& mesh, const Surface& surface,
                const std::string& axes, std::vector<RawColumn>& columns) {
    std::vector<std::size_t> items;
    for (const MeshFace& face : surface.faces)
        for (const int point : face.points) items.push_back(static_cast<std::size_t>(point));
    if (surface.faces.empty()) {
        items.resize(mesh.points.size());
        std::iota(items.begin(), items.end(), 0U);
    }
    std::ranges::sort(items);
    items.erase(std::ranges::unique(items).begin(), items.end());
    if (surface.is_plane)
        std::ranges::stable_sort(
            items, {}, [&](std::size_t i) { return mesh.points[i][axes[0] == 'x' ? 0 : 1]; });
    std::map<std::size_t, int> number;
    for (std::size_t i = 0; i < items.size(); ++i) number[items[i]] = static_cast<int>(i);
    for (const MeshFace& face : surface.faces) {
        for (const int point : face.points)
            field.faces.points.push_back(number[static_cast<std::size_t>(point)]);
        field.faces.offsets.push_back(static_cast<int>(field.faces.points.size()));
    }
    std::vector<Vector> at;
    for (const std::size_t i : items) at.push_back(mesh.points[i]);
    add_positions(columns, at, axes, surface.is_plane, mesh.is_axisymmetric);
    add_arrays(columns, mesh.point_arrays, items, axes);
}

void add_centres(const MeshData& mesh, const Surface& surface, const std::string& axes,
                 std::vector<RawColumn>& columns) {
    std::vector<Vector> at;
    std::vector<std::size_t> items;
    RawColumn sizes{"size of the face", "area", {}, {}};
    for (const MeshFace& face : surface.faces) {
        at.push_back(face.centre);
        items.push_back(static_cast<std::size_t>(face.cell));
        sizes.values.push_back(face.size);
    }
    add_positions(columns, at, axes, surface.is_plane, mesh.is_axisymmetric);
    if (!mesh.is_axisymmetric) columns.push_back(std::move(sizes));
    add_arrays(columns, mesh.cell_arrays, items, axes);
}

void check_arrays(const MeshData& mesh, const std::string& place) {
    std::vector<std::string> names;
    for (const auto* arrays : {&mesh.point_arrays, &mesh.cell_arrays})
        for (const MeshArray& array : *arrays) names.push_back(array.name);
    const auto wanted = [](Meaning meaning) { return is_contact(meaning) || is_stress(meaning); };
    if (mesh.points.empty()) io::fail(place, "", "the mesh has no points", "write the surface");
    if (!some(mesh.point_arrays, wanted) && !some(mesh.cell_arrays, wanted))
        io::fail(place, "",
                 "no pressure, traction, nodal force or stress; the file has " +
                     (names.empty() ? "no fields" : io::joined(names)),
                 "write the contact pressure, for example as contact_pressure");
}

}  // namespace

bool has_contact_values(const MeshData& mesh) {
    for (const auto* arrays : {&mesh.point_arrays, &mesh.cell_arrays})
        for (const MeshArray& array : *arrays)
            for (const std::size_t k : components(array, is_contact))
                for (std::size_t i = k; i < array.values.size();
                     i += static_cast<std::size_t>(array.n_components))
                    if (array.values[i] != 0) return true;
    return false;
}

std::string add_surface(MeshField& field, const MeshData& mesh, const std::string& place) {
    check_arrays(mesh, place);
    const bool at_points =
        some(mesh.point_arrays, is_contact) ||
        (!some(mesh.cell_arrays, is_contact) && some(mesh.point_arrays, is_stress));
    std::vector<bool> is_loaded =
        at_points ? loaded(mesh.point_arrays, mesh.points.size()) : std::vector<bool>();
    if (!at_points) {  // all points of cells that carry load
        is_loaded.resize(mesh.points.size(), false);
        const auto cells = loaded(mesh.cell_arrays, mesh.n_cells());
        for (std::size_t cell = 0; cell < cells.size(); ++cell)
            for (auto k = mesh.offsets[cell]; cells[cell] && k < mesh.offsets[cell + 1]; ++k)
                is_loaded[static_cast<std::size_t>(
                    mesh.connectivity[static_cast<std::size_t>(k)])] = true;
    }
    Surface surface;
    if (is_body(mesh, is_loaded)) {
        surface = of_body(mesh, is_loaded, place);
    } else {
        if (dimension_of(mesh) > 0) surface.faces = cells_as_faces(mesh);
        std::vector<std::size_t> all(surface.faces.size());
        std::iota(all.begin(), all.end(), 0U);
        surface.is_plane = dimension_of(mesh) == 1;
        surface.normal = surface.is_plane ? Vector{0, 1, 0} : mean_normal(surface.faces, all);
        surface.how = "the cells of the file";
        if (surface.faces.empty()) surface.normal = {0, 0, 1};
    }
    const std::string axes = axes_of(surface.normal, surface.is_plane);
    std::vector<RawColumn> columns;
    if (at_points)
        add_points(field, mesh, surface, axes, columns);
    else
        add_centres(mesh, surface, axes, columns);
    field.notes.push_back("surface: " + surface.how);
    if (axes != "xyz")
        field.notes.push_back(std::string("axes: the surface's normal is along ") +
                              "xyz"[axes.find('z')] + ", which is read as z" +
                              (surface.is_plane ? "" : ", and z as " + axes.substr(2)));
    for (const MeshArray& array : at_points ? mesh.cell_arrays : mesh.point_arrays)
        field.notes.push_back("array " + io::toml_string(array.name) + " at " +
                              (at_points ? "cells" : "points") + " is not used");
    add_columns(field, std::move(columns), place, Twice::specific_first);
    check_field(field, place);
    return axes;
}

}  // namespace tricontact::benchmarks
