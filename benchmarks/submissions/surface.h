#pragma once

#include <array>
#include <string>
#include <vector>

#include "benchmarks/submissions/mesh_cells.h"

namespace tricontact::benchmarks {

/// The faces of a mesh that are in contact, or may come into contact.
struct Surface {
    std::vector<MeshFace> faces;
    std::array<double, 3> normal{};  ///< mean, outward
    bool is_plane = false;           ///< of lines
    std::string how;                 ///< it was found
};

/// Of a body the faces of its boundary whose corners carry load, and what continues them smoothly;
/// where nothing is loaded, or points within the body are too, the highest faces. Of a surface its
/// cells; of points nothing. `is_loaded`: by points; Throws contact::InputError.
Surface find_surface(const MeshData& mesh, const std::vector<bool>& is_loaded,
                     const std::string& place);

/// Letters of the file's axes, where z is that of the normal: "xzy" where y is normal.
std::string axes_of(const Surface& surface);

}  // namespace tricontact::benchmarks
