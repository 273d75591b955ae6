#include "benchmarks/submissions/surface_field.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "benchmarks/submissions/column_names.h"
#include "benchmarks/submissions/columns.h"
#include "benchmarks/submissions/mesh_cells.h"
#include "benchmarks/submissions/surface.h"
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
    items.erase(std::unique(items.begin(), items.end()), items.end());
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
    for (const std::uint8_t type : mesh.types)
        if (dimension_of_cell(type) < 0)
            io::fail(place, "", "cells of VTK type " + std::to_string(type) + " are not read",
                     "write the contact surface alone, or a table of columns (.csv)");
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
    const Surface surface = find_surface(mesh, is_loaded, place);
    const std::string axes = axes_of(surface);
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
