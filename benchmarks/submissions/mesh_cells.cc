#include "benchmarks/submissions/mesh_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "benchmarks/submissions/cell_shapes.h"
#include "contact/base/error.h"

namespace tricontact::benchmarks {

namespace {

using Vector = std::array<double, 3>;

Vector minus(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::span<const int> nodes_of(const MeshData& mesh, std::size_t cell) {
    const auto begin = static_cast<std::size_t>(mesh.offsets[cell]),
               end = static_cast<std::size_t>(mesh.offsets[cell + 1]);
    return std::span(mesh.connectivity).subspan(begin, end - begin);
}

Vector mean(const MeshData& mesh, std::span<const int> nodes) {
    Vector sum{};
    for (const int node : nodes)
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] +=
                mesh.points[static_cast<std::size_t>(node)][k] / static_cast<double>(nodes.size());
    return sum;
}

/// Normal, size and centre; a line's normal lies in the plane z = const.
void measure(const MeshData& mesh, MeshFace& face) {
    const auto at = [&](int k) -> const Vector& {
        return mesh.points[static_cast<std::size_t>(face.points[static_cast<std::size_t>(k)])];
    };
    face.centre =
        mean(mesh, std::span(face.points).first(static_cast<std::size_t>(face.n_corners)));
    Vector normal{};
    if (face.n_corners == 2) {
        const Vector along = minus(at(1), at(0));
        normal = {along[1], -along[0], 0};
        face.size = std::sqrt(dot(along, along));
    } else if (face.n_corners == 3) {
        normal = cross(minus(at(1), at(0)), minus(at(2), at(0)));
        face.size = std::sqrt(dot(normal, normal)) / 2;
    } else if (face.n_corners == 4) {
        normal = cross(minus(at(2), at(0)), minus(at(3), at(1)));
        face.size = std::sqrt(dot(normal, normal)) / 2;
    }
    const double length = std::sqrt(dot(normal, normal));
    for (std::size_t k = 0; k < 3; ++k) face.normal[k] = length > 0 ? normal[k] / length : 0;
}

/// Corners, then the middle nodes of quadratic cells.
MeshFace face_of_cell(std::span<const int> nodes, std::uint8_t type, std::size_t which) {
    const CellShape& shape = cell_shape(type);
    const std::vector<int>& corners = shape.faces[which];
    MeshFace face;
    face.n_corners = static_cast<int>(corners.size());
    for (const int corner : corners) face.points.push_back(nodes[static_cast<std::size_t>(corner)]);
    if (!is_quadratic(type)) return face;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners.size() == 2 && i == 1) break;
        const int a = corners[i], b = corners[(i + 1) % corners.size()];
        for (std::size_t k = 0; k < shape.edges.size(); ++k) {
            const auto& edge = shape.edges[k];
            const std::size_t middle = static_cast<std::size_t>(shape.n_corners) + k;
            if (((edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a)) &&
                middle < nodes.size())
                face.points.push_back(nodes[middle]);
        }
    }
    if (type == 29 && nodes.size() > 20 + which) face.points.push_back(nodes[20 + which]);
    return face;
}

/// Too few nodes for its type: nothing that a reader of VTK lets through, but other files do.
void check_nodes(std::span<const int> nodes, const CellShape& shape) {
    if (nodes.size() < static_cast<std::size_t>(shape.n_corners))
        throw contact::InputError("a cell has fewer nodes than its type needs");
}

}  // namespace

int dimension_of_cell(std::uint8_t type) {
    return cell_shape(type).dimension;
}

int dimension_of(const MeshData& mesh) {
    int dimension = -1;
    for (const auto type : mesh.types) dimension = std::max(dimension, dimension_of_cell(type));
    return dimension;
}

void keep_used_points(MeshData& mesh) {
    std::vector<int> number(mesh.points.size(), -1);
    for (const int node : mesh.connectivity) number[static_cast<std::size_t>(node)] = 0;
    std::size_t n = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] < 0) continue;
        number[i] = static_cast<int>(n);
        mesh.points[n] = mesh.points[i];
        for (MeshArray& array : mesh.point_arrays) {
            const auto step = static_cast<std::ptrdiff_t>(array.n_components);
            std::copy_n(array.values.begin() + static_cast<std::ptrdiff_t>(i) * step, step,
                        array.values.begin() + static_cast<std::ptrdiff_t>(n) * step);
        }
        ++n;
    }
    mesh.points.resize(n);
    for (MeshArray& array : mesh.point_arrays)
        array.values.resize(n * static_cast<std::size_t>(array.n_components));
    for (int& node : mesh.connectivity) node = number[static_cast<std::size_t>(node)];
}

std::vector<int> first_of_same_place(const MeshData& mesh) {
    std::vector<int> order(mesh.points.size()), first(mesh.points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](int i) -> const Vector& {
        return mesh.points[static_cast<std::size_t>(i)];
    };
    std::ranges::sort(order, [&](int a, int b) { return at(a) != at(b) ? at(a) < at(b) : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && at(order[i]) == at(order[i - 1]);
        first[static_cast<std::size_t>(order[i])] =
            same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
    return first;
}

std::vector<MeshFace> boundary_faces(const MeshData& mesh, const std::vector<int>& same_point,
                                     std::size_t& n_inner) {
    struct Keyed {
        std::array<int, 4> key;
        int cell, which;
    };
    const int dimension = dimension_of(mesh);
    std::vector<Keyed> all;
    for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) {
        const CellShape& shape = cell_shape(mesh.types[cell]);
        if (shape.dimension != dimension) continue;
        const auto nodes = nodes_of(mesh, cell);
        check_nodes(nodes, shape);
        for (std::size_t which = 0; which < shape.faces.size(); ++which) {
            Keyed one{{-1, -1, -1, -1}, static_cast<int>(cell), static_cast<int>(which)};
            for (std::size_t k = 0; k < shape.faces[which].size(); ++k)
                one.key[k] = same_point[static_cast<std::size_t>(
                    nodes[static_cast<std::size_t>(shape.faces[which][k])])];
            std::ranges::sort(one.key);
            all.push_back(one);
        }
    }
    std::ranges::sort(all, [](const Keyed& a, const Keyed& b) {
        return a.key != b.key ? a.key < b.key
                              : std::pair(a.cell, a.which) < std::pair(b.cell, b.which);
    });
    std::vector<MeshFace> faces;
    n_inner = 0;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t next = i + 1;
        while (next < all.size() && all[next].key == all[i].key) ++next;
        if (next == i + 1) {
            const auto cell = static_cast<std::size_t>(all[i].cell);
            const auto nodes = nodes_of(mesh, cell);
            MeshFace face =
                face_of_cell(nodes, mesh.types[cell], static_cast<std::size_t>(all[i].which));
            face.cell = all[i].cell;
            measure(mesh, face);
            if (dot(face.normal, minus(face.centre, mean(mesh, nodes))) < 0)
                for (double& component : face.normal) component = -component;
            faces.push_back(std::move(face));
        } else {
            ++n_inner;
        }
        i = next;
    }
    std::ranges::stable_sort(faces, {}, &MeshFace::cell);
    return faces;
}

std::vector<bool> points_of_boundary(const MeshData& mesh) {
    const std::vector<int> same = first_of_same_place(mesh);
    std::vector<bool> is_there(mesh.points.size(), false);
    std::size_t n_inner = 0;
    for (const MeshFace& face : boundary_faces(mesh, same, n_inner))
        for (const int p : face.points)
            is_there[static_cast<std::size_t>(same[static_cast<std::size_t>(p)])] = true;
    for (std::size_t i = 0; i < is_there.size(); ++i)
        is_there[i] = is_there[static_cast<std::size_t>(same[i])];
    return is_there;
}

std::vector<MeshFace> all_faces(const MeshData& mesh) {
    std::vector<MeshFace> faces;
    for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) {
        const CellShape& shape = cell_shape(mesh.types[cell]);
        if (shape.dimension != 3) continue;
        check_nodes(nodes_of(mesh, cell), shape);
        for (std::size_t which = 0; which < shape.faces.size(); ++which) {
            faces.push_back(face_of_cell(nodes_of(mesh, cell), mesh.types[cell], which));
            faces.back().cell = static_cast<int>(cell);
        }
    }
    return faces;
}

std::vector<MeshFace> cells_as_faces(const MeshData& mesh) {
    const int dimension = dimension_of(mesh);
    std::vector<MeshFace> faces;
    const auto add = [&](std::size_t cell, std::vector<int> points, int n_corners) {
        MeshFace face{
            .points = std::move(points), .n_corners = n_corners, .cell = static_cast<int>(cell)};
        measure(mesh, face);
        faces.push_back(std::move(face));
    };
    for (std::size_t cell = 0; cell < mesh.n_cells(); ++cell) {
        const std::uint8_t type = mesh.types[cell];
        const CellShape& shape = cell_shape(type);
        if (shape.dimension != dimension) continue;
        const auto nodes = nodes_of(mesh, cell);
        const auto n = nodes.size();
        if (type == 4) {
            for (std::size_t k = 1; k < n; ++k) add(cell, {nodes[k - 1], nodes[k]}, 2);
        } else if (type == 6) {
            for (std::size_t k = 2; k < n; ++k)
                add(cell, {nodes[k - 2], nodes[k - 1], nodes[k]}, 3);
        } else if (type == 7 && n != 4) {
            for (std::size_t k = 2; k < n; ++k) add(cell, {nodes[0], nodes[k - 1], nodes[k]}, 3);
        } else {
            check_nodes(nodes, shape);
            std::vector<int> points(nodes.begin(), nodes.begin() + shape.n_corners);
            if (type == 8) std::swap(points[2], points[3]);
            if (is_quadratic(type))
                points.insert(points.end(), nodes.begin() + shape.n_corners, nodes.end());
            add(cell, std::move(points), shape.n_corners);
        }
    }
    return faces;
}

}  // namespace tricontact::benchmarks
