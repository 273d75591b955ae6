#include "fem/triangulation.h"

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <string>

#include "contact/error.h"

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

}  // namespace tricontact::fem
