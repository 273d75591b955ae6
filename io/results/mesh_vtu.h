#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/results/provenance.h"

namespace tricontact::io {

/// Hexahedra and their boundary faces to look at. Positions in m; nodes in VTK's order.
struct MeshView {
    std::span<const std::array<double, 3>> points;
    std::span<const std::array<int, 8>> hexes;
    std::span<const std::uint8_t> regions;  ///< per hexahedron, an index into `region_names`
    std::span<const std::array<int, 4>> faces;
    std::span<const std::uint8_t> boundaries;  ///< per face, an index into `boundary_names`
    std::vector<std::string> region_names, boundary_names;
};

/// The mesh as one `.vtu`: hexahedra, then faces as quadrilaterals. Cell data: `dimension` (3 or 2)
/// tells them apart; `region` and `boundary` are 255 where they do not apply; field data: the names
/// that the numbers stand for. Throws contact::InputError if the file cannot be written,
/// std::invalid_argument for lists of different lengths.
void write_mesh_vtu(const std::string& path, const MeshView& mesh, const Provenance& provenance);

}  // namespace tricontact::io
