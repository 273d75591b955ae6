#pragma once

#include <optional>
#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// A block with a finely meshed contact patch about the origin of its upper surface. Lengths in m.
struct LayerMeshSpec {
    double size = 0;                  ///< element edge h in the contact patch
    double patch_x = 0, patch_y = 0;  ///< half sides of the patch; whole numbers of `size`
    double half_x = 0, half_y = 0;    ///< half sides of the block, >= those of the patch
    double thickness = 0;             ///< b of the layer
    double lower_thickness = 0;       ///< of a second layer below; 0: none
    double growth = 1.8;              ///< of neighbouring elements sideways; in depth growth^0.8
    bool half_model = false;          ///< y >= 0 only, plane of symmetry y = 0
    /// A slice in plane strain: one element along y between two planes of symmetry, y = 0 and
    /// half_y, all of its surface along y the patch. Needs half_model, patch_y = half_y.
    bool plane_strain = false;
    /// A patch that is graded along y: edges of `end_size` over its outermost `end_length` and next
    /// to it on both sides, growing from there inwards and outwards; empty: `size` throughout.
    /// Needs half_model.
    struct Ends {
        double size = 0, length = 0;
    };
    std::optional<Ends> ends;
};

/// Structured hexahedra, graded outwards and downwards from the patch: their first edge is
/// `size`, neighbours grow by at most `growth` (short strips: see layer_grid.h). Patch nodes are
/// whole multiples of `size` (along y unless graded or a slice) and the mesh is its own mirror
/// image, to the last bit. The same spec gives the same mesh, numbers included: nodes and hexahedra
/// x fastest, z slowest, faces by name. Throws contact::InputError for a spec that is none, or asks
/// for more than 10 million elements.
HexMesh make_layer_mesh(const LayerMeshSpec& spec);

/// The same as a gmsh geometry for people to read and change (.geo), which gmsh meshes alike to
/// some digits.
std::string layer_geometry(const LayerMeshSpec& spec);

}  // namespace tricontact::meshes
