#include "fem/q2_space.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "contact/base/error.h"

// What comes from deal.II: the triangulation, the numbering of triquadratic nodes, integration. Its
// types end here: no header of this room includes deal.II.

namespace tricontact::fem {

namespace {

// deal.II's vertices of hexahedra and quadrilaterals run with x fastest.
constexpr std::array<int, 8> hex_vertices{0, 1, 3, 2, 4, 5, 7, 6};
constexpr std::array<int, 4> quad_vertices{0, 1, 3, 2};

std::vector<dealii::Point<3>> points_of(const meshes::HexMesh& mesh) {
    std::vector<dealii::Point<3>> points;
    points.reserve(mesh.nodes.size());
    for (const auto& x : mesh.nodes) points.emplace_back(x[0], x[1], x[2]);
    return points;
}

}  // namespace

void triangulate(const meshes::HexMesh& mesh, dealii::Triangulation<3, 3>& triangulation) {
    std::vector<dealii::CellData<3>> cells(mesh.hexes.size(), dealii::CellData<3>(8));
    for (std::size_t c = 0; c < cells.size(); ++c) {
        for (int v = 0; v < 8; ++v) cells[c].vertices[v] = mesh.hexes[c][hex_vertices[v]];
        cells[c].material_id = static_cast<dealii::types::material_id>(mesh.regions[c]);
    }
    dealii::SubCellData boundary;
    for (const auto& face : mesh.faces) {
        auto& quad = boundary.boundary_quads.emplace_back(4);
        for (int v = 0; v < 4; ++v) quad.vertices[v] = face.nodes[quad_vertices[v]];
        quad.boundary_id = static_cast<dealii::types::boundary_id>(face.boundary) + 1;
    }
    dealii::GridTools::consistently_order_cells(cells);
    triangulation.create_triangulation(points_of(mesh), cells, boundary);
}

void require_name(unsigned boundary_id, const std::array<double, 3>& centre) {
    if (boundary_id >= 1 && boundary_id <= meshes::n_boundaries) return;
    throw contact::InputError("mesh: the boundary face about (" + std::to_string(centre[0]) + ", " +
                              std::to_string(centre[1]) + ", " + std::to_string(centre[2]) +
                              ") m has no name; put every boundary face into exactly one "
                              "physical group");
}

const std::array<std::array<int, 3>, 27> node_positions{{
    {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},  // corners
    {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},  // edges
    {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1},             //
    {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2},             // faces
    {1, 1, 1},
}};

namespace {

constexpr std::size_t face_gauss_points = 3, nodes_of_face = 9;

// Two numberings meet here: deal.II's within a cell and on its faces, and VTK's, which everything
// else in this program uses. They are matched by positions on the unit cell, so that no table of
// deal.II's is copied. Face nodes go round counter-clockwise seen from outside (right hand,
// outward).
// For each of VTK's nodes, its number within a cell of `fe`.
std::array<unsigned, 27> numbers_within_cell(const dealii::FiniteElement<3>& fe) {
    std::array<unsigned, 27> numbers{};
    const auto& support = fe.get_unit_support_points();
    for (unsigned i = 0; i < 27; ++i) {
        const auto matches = [&](const std::array<int, 3>& p) {
            return std::lround(2 * support[i][0]) == p[0] &&
                   std::lround(2 * support[i][1]) == p[1] && std::lround(2 * support[i][2]) == p[2];
        };
        const auto at = std::find_if(node_positions.begin(), node_positions.end(), matches);
        numbers[at - node_positions.begin()] = i;
    }
    return numbers;
}

// VTK's numbers within a hexahedron of the nine nodes of deal.II's face `face`, outward.
std::array<int, 9> nodes_on_face(int face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    constexpr std::array<std::array<int, 2>, 9> quad{
        {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}}};
    std::array<int, 9> nodes{};
    for (int i = 0; i < 9; ++i) {
        std::array<int, 3> at{};
        const bool upper = face % 2 == 1;  // on the lower side u and v change places: outward
        at[axis] = upper ? 2 : 0;
        at[upper ? u : v] = quad[i][0];
        at[upper ? v : u] = quad[i][1];
        nodes[i] = static_cast<int>(std::find(node_positions.begin(), node_positions.end(), at) -
                                    node_positions.begin());
    }
    return nodes;
}

}  // namespace

struct Q2Space::Parts {
    dealii::Triangulation<3> triangulation;
    dealii::FE_Q<3> fe{2};
    dealii::MappingQ1<3> mapping;
    dealii::DoFHandler<3> dofs{triangulation};
    std::array<unsigned, 27> within_cell = numbers_within_cell(fe);
    std::vector<dealii::DoFHandler<3>::active_cell_iterator> iterators;
    std::vector<std::pair<std::size_t, int>> cell_of_face;  // and the face's number there

    explicit Parts(const meshes::HexMesh& mesh) {
        triangulate(mesh, triangulation);
        dofs.distribute_dofs(fe);
        for (const auto& cell : dofs.active_cell_iterators()) iterators.push_back(cell);
    }
};

Q2Space::Q2Space(const meshes::HexMesh& mesh) : parts_(std::make_unique<Parts>(mesh)) {
    const auto& dofs = parts_->dofs;
    std::vector<dealii::types::global_dof_index> indices(27);
    for (const auto& cell : parts_->iterators) {
        regions.push_back(static_cast<meshes::Region>(cell->material_id()));
        cell->get_dof_indices(indices);
        auto& numbers = cells.emplace_back();
        for (int i = 0; i < 27; ++i) numbers[i] = static_cast<int>(indices[parts_->within_cell[i]]);
    }
    std::vector<dealii::Point<3>> points(dofs.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(parts_->mapping, dofs, points);
    for (const auto& x : points) nodes.push_back({x[0], x[1], x[2]});
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (int f = 0; f < 6; ++f)
            if (parts_->iterators[c]->face(f)->at_boundary()) add_face(c, f);
}
Q2Space::~Q2Space() = default;

void Q2Space::add_face(std::size_t c, int f) {
    const auto face = parts_->iterators[c]->face(f);
    const auto x = face->center();
    require_name(face->boundary_id(), {x[0], x[1], x[2]});
    auto& [numbers, boundary] = faces.emplace_back();
    boundary = static_cast<meshes::Boundary>(face->boundary_id() - 1);
    const auto local = nodes_on_face(f);
    for (int i = 0; i < 9; ++i) numbers[i] = cells[c][local[i]];
    parts_->cell_of_face.emplace_back(c, f);
}

// Three Gauss points per axis integrate the products of two quadratic functions, of degree 4,
// exactly on a parallelogram (degree 5).
std::array<std::array<double, 9>, 9> Q2Space::face_mass(std::size_t face) const {
    const auto [c, f] = parts_->cell_of_face[face];
    dealii::FEFaceValues<3> values(parts_->mapping, parts_->fe,
                                   dealii::QGauss<2>(face_gauss_points),
                                   dealii::update_values | dealii::update_JxW_values);
    values.reinit(parts_->iterators[c], f);
    const auto local = nodes_on_face(f);
    std::array<std::array<double, 9>, 9> mass{};
    for (const unsigned q : values.quadrature_point_indices())
        for (std::size_t i = 0; i < nodes_of_face; ++i)
            for (std::size_t j = 0; j < nodes_of_face; ++j)
                mass[i][j] += values.shape_value(parts_->within_cell[local[i]], q) *
                              values.shape_value(parts_->within_cell[local[j]], q) * values.JxW(q);
    return mass;
}

struct ElementValues::Parts {
    const Q2Space::Parts& space;
    dealii::FEValues<3> values;
};

ElementValues::ElementValues(const Q2Space& space, int n)
    : parts_(new Parts{*space.parts_,
                       {space.parts_->mapping, space.parts_->fe, dealii::QGauss<3>(n),
                        dealii::update_gradients | dealii::update_JxW_values |
                            dealii::update_quadrature_points}}) {
    points.resize(parts_->values.n_quadrature_points);
    gradients.resize(points.size());
}
ElementValues::~ElementValues() = default;

void ElementValues::reinit(std::size_t cell) {
    auto& [space, values] = *parts_;
    values.reinit(space.iterators[cell]);
    weights = values.get_JxW_values();
    for (const unsigned q : values.quadrature_point_indices()) {
        const auto& x = values.quadrature_point(q);
        points[q] = {x[0], x[1], x[2]};
        for (int i = 0; i < 27; ++i) {
            const auto& gradient = values.shape_grad(space.within_cell[i], q);
            gradients[q][i] = {gradient[0], gradient[1], gradient[2]};
        }
    }
}

}  // namespace tricontact::fem
