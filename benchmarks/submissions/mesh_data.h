#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tricontact::benchmarks {

/// Values at points or cells of a mesh, the components of one after the other.
struct MeshArray {
    std::string name;  ///< by which its meaning is found
    int n_components = 1;
    std::vector<double> values;
    std::vector<std::string> headings = {};  ///< of its components in the file; empty: as `name`
};

/// A mesh with fields as a file holds it. Cells have VTK's types and orders of nodes.
struct MeshData {
    std::string name;  ///< of the set, block, part; empty: the file has none
    std::vector<std::array<double, 3>> points;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> offsets{0};  ///< n cells + 1
    std::vector<int> connectivity;
    std::vector<MeshArray> point_arrays, cell_arrays;
    bool is_axisymmetric = false;  ///< x is the distance from the axis, y runs along it
    /// Pieces of one mesh, whose common points stand in each of them.
    bool has_pieces = false;

    std::size_t n_cells() const { return types.size(); }
};

}  // namespace tricontact::benchmarks
