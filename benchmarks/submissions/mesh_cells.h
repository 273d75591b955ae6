#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "benchmarks/submissions/mesh_data.h"

namespace tricontact::benchmarks {

/// A face of the boundary of a body, or a cell of a surface: its points in VTK's order, corners
/// first.
struct MeshFace {
    std::vector<int> points;
    int n_corners = 0;
    int cell = 0;                    ///< to which it belongs
    std::array<double, 3> normal{};  ///< outward, of length 1; of a surface's cell as it is ordered
    double size = 0;                 ///< area, length of a line
    std::array<double, 3> centre{};  ///< mean of its corners
};

/// 0 to 3 by VTK's type; -1 of a type that is not read.
int dimension_of_cell(std::uint8_t type);

/// Faces of volumes, edges of areas ... that belong to one cell only, of the cells of the greatest
/// dimension in the mesh. `n_inner`: faces between two cells.
std::vector<MeshFace> boundary_faces(const MeshData& mesh, const std::vector<int>& same_point,
                                     std::size_t& n_inner);

/// Whether a point stands on the boundary; points of the same place are one.
std::vector<bool> points_of_boundary(const MeshData& mesh);

/// All faces of all volumes, each as often as it has cells.
std::vector<MeshFace> all_faces(const MeshData& mesh);

/// The cells of the greatest dimension themselves; polygons as triangles, polylines as segments.
std::vector<MeshFace> cells_as_faces(const MeshData& mesh);

/// Removes points that no cell has, with their values.
void keep_used_points(MeshData& mesh);

/// For each point the first one of the same coordinates.
std::vector<int> first_of_same_place(const MeshData& mesh);

/// Greatest dimension of the cells; -1 without cells.
int dimension_of(const MeshData& mesh);

}  // namespace tricontact::benchmarks
