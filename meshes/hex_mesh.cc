#include "meshes/hex_mesh.h"

#include <algorithm>

namespace tricontact::meshes {

const char* name_of(Boundary boundary) {
    static constexpr std::array<const char*, n_boundaries> names{"contact", "free_top", "base",
                                                                 "sides", "symmetry"};
    return names.at(static_cast<std::size_t>(boundary));
}

const char* name_of(Region region) {
    static constexpr std::array<const char*, n_regions> names{"layer", "lower_layer"};
    return names.at(static_cast<std::size_t>(region));
}

bool HexMesh::has_symmetry() const {
    return std::any_of(faces.begin(), faces.end(),
                       [](const Face& face) { return face.boundary == Boundary::symmetry; });
}

}  // namespace tricontact::meshes
