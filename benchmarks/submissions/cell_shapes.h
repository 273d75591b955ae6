#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace tricontact::benchmarks {

/// A kind of cells: faces by their corners, and edges, in whose order middle nodes stand.
struct CellShape {
    int dimension = -1, n_corners = 0;
    std::vector<std::vector<int>> faces;
    std::vector<std::array<int, 2>> edges;
};

/// By VTK's number (vtkCellType.h); of Lagrange cells the corners alone. Dimension -1: not read.
const CellShape& cell_shape(std::uint8_t type);

/// Has a middle node on each edge.
bool is_quadratic(std::uint8_t type);

}  // namespace tricontact::benchmarks
