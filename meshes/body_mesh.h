#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Reads a gmsh file of a body of any form, hexahedra as read_mesh() takes them. Physical surfaces:
/// "contact", "support" (what holds it), "symmetry" (in y = 0, the body at y >= 0); the physical
/// volume "body". Boundary faces without a name are free. In the mesh "support" is Boundary::base,
/// a free face Boundary::free_top, the volume Region::layer.
///
/// Verified as by verify() but for the places of the faces: names, Jacobians, nodes that are shared
/// by what touches, one piece, the support away from the contact. Throws contact::InputError.
HexMesh read_body_mesh(const std::string& path, double unit);

/// Throws contact::InputError unless all contact faces face down (`up`: up) to within 60 degrees:
/// contact is sought along z.
void check_facing(const HexMesh& mesh, bool up, const std::string& name);

/// Throws contact::InputError where a node of a body that is to be above the plane z = 0 is below.
void check_above_plane(const HexMesh& mesh, const std::string& name);

/// The same body mirrored in z = 0, so that what faced down faces up.
HexMesh turned_over(const HexMesh& mesh);

}  // namespace tricontact::meshes
