#include "fem/deal_ii/q2_elements.h"

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
// types end here: no header includes deal.II.

namespace tricontact::fem::deal_ii {

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

namespace {

constexpr std::size_t face_gauss_points = 3, nodes_of_face = 9;

// Two numberings meet here: deal.II's within a cell and on its faces, and VTK's, which everything
// else in this program uses. They are matched by positions on the unit cell.
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

// Of deal.II's face `face`.
std::array<int, 9> nodes_on(int face) {
    return nodes_on_face(face / 2, face % 2 == 1);
}

using Cells = std::vector<dealii::DoFHandler<3>::active_cell_iterator>;

class Rule : public ElementRule {
  public:
    Rule(const dealii::MappingQ1<3>& mapping, const dealii::FE_Q<3>& fe, int n, const Cells& cells,
         const std::array<unsigned, 27>& within_cell)
        : values_(mapping, fe, dealii::QGauss<3>(n),
                  dealii::update_gradients | dealii::update_JxW_values |
                      dealii::update_quadrature_points),
          cells_(cells),
          within_cell_(within_cell) {}

    void reinit(std::size_t cell, ElementValues& to) override {
        values_.reinit(cells_[cell]);
        to.weights = values_.get_JxW_values();
        for (const unsigned q : values_.quadrature_point_indices()) {
            const auto& x = values_.quadrature_point(q);
            to.points[q] = {x[0], x[1], x[2]};
            for (int i = 0; i < 27; ++i) {
                const auto& gradient = values_.shape_grad(within_cell_[i], q);
                to.gradients[q][i] = {gradient[0], gradient[1], gradient[2]};
            }
        }
    }

  private:
    dealii::FEValues<3> values_;
    const Cells& cells_;
    const std::array<unsigned, 27>& within_cell_;
};

class Elements : public Q2Elements {
  public:
    Elements(const meshes::HexMesh& mesh, Q2Space& space) {
        triangulate(mesh, triangulation_);
        dofs_.distribute_dofs(fe_);
        std::vector<dealii::types::global_dof_index> indices(27);
        for (const auto& cell : dofs_.active_cell_iterators()) {
            cells_.push_back(cell);
            space.regions.push_back(static_cast<meshes::Region>(cell->material_id()));
            cell->get_dof_indices(indices);
            auto& numbers = space.cells.emplace_back();
            for (int i = 0; i < 27; ++i) numbers[i] = static_cast<int>(indices[within_cell_[i]]);
        }
        std::vector<dealii::Point<3>> points(dofs_.n_dofs());
        dealii::DoFTools::map_dofs_to_support_points(mapping_, dofs_, points);
        for (const auto& x : points) space.nodes.push_back({x[0], x[1], x[2]});
        for (std::size_t c = 0; c < cells_.size(); ++c)
            for (int f = 0; f < 6; ++f)
                if (cells_[c]->face(f)->at_boundary()) add_face(c, f, space);
    }

    // Three Gauss points per axis integrate the products of two quadratic functions, of degree 4,
    // exactly on a parallelogram (degree 5).
    std::array<std::array<double, 9>, 9> face_mass(std::size_t face) const override {
        const auto [c, f] = cell_of_face_[face];
        dealii::FEFaceValues<3> values(mapping_, fe_, dealii::QGauss<2>(face_gauss_points),
                                       dealii::update_values | dealii::update_JxW_values);
        values.reinit(cells_[c], f);
        const auto local = nodes_on(f);
        std::array<std::array<double, 9>, 9> mass{};
        for (const unsigned q : values.quadrature_point_indices())
            for (std::size_t i = 0; i < nodes_of_face; ++i)
                for (std::size_t j = 0; j < nodes_of_face; ++j)
                    mass[i][j] += values.shape_value(within_cell_[local[i]], q) *
                                  values.shape_value(within_cell_[local[j]], q) * values.JxW(q);
        return mass;
    }

    std::unique_ptr<ElementRule> rule(int n) const override {
        return std::make_unique<Rule>(mapping_, fe_, n, cells_, within_cell_);
    }

  private:
    void add_face(std::size_t c, int f, Q2Space& space) {
        const auto face = cells_[c]->face(f);
        const auto x = face->center();
        require_name(face->boundary_id(), {x[0], x[1], x[2]});
        auto& [numbers, boundary] = space.faces.emplace_back();
        boundary = static_cast<meshes::Boundary>(face->boundary_id() - 1);
        const auto local = nodes_on(f);
        for (int i = 0; i < 9; ++i) numbers[i] = space.cells[c][local[i]];
        cell_of_face_.emplace_back(c, f);
    }

    dealii::Triangulation<3> triangulation_;
    dealii::FE_Q<3> fe_{2};
    dealii::MappingQ1<3> mapping_;
    dealii::DoFHandler<3> dofs_{triangulation_};
    std::array<unsigned, 27> within_cell_ = numbers_within_cell(fe_);
    Cells cells_;
    std::vector<std::pair<std::size_t, int>> cell_of_face_;  // and the face's number there
};

}  // namespace

std::unique_ptr<const Q2Elements> q2_elements(const meshes::HexMesh& mesh, Q2Space& space) {
    return std::make_unique<Elements>(mesh, space);
}

}  // namespace tricontact::fem::deal_ii

namespace tricontact::fem {

std::unique_ptr<const Q2Elements> q2_elements(const meshes::HexMesh& mesh, Q2Space& space) {
    return deal_ii::q2_elements(mesh, space);
}

}  // namespace tricontact::fem
