#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Reads a gmsh file (.msh 4.1 or 2.2, text or binary) whose physical groups have the names of
/// Boundary and Region; `unit` [m] is the length of 1 in the file. The mesh is verified. Throws
/// contact::InputError: no such file, not a mesh, damaged, other elements than straight hexahedra,
/// unknown or missing names, and what verify() finds. gmsh has no part in it: it runs texts as
/// scripts, and wrong counts in a file corrupt its memory.
HexMesh read_mesh(const std::string& path, double unit);

/// Writes a gmsh 4.1 text file `*.msh` in metres, 16 digits, at once or not at all. Faces and
/// hexahedra keep their order. By gmsh, in a library of its own: meshes/gmsh/. Throws
/// contact::InputError if that fails.
void write_mesh(const HexMesh& mesh, const std::string& path);

/// What a solver relies on: there is a contact, a base and a layer; all Jacobians are positive;
/// touching hexahedra share their nodes and the body is in one piece; every boundary face has
/// exactly one name, and no other face has; contact and free top lie in z = 0, the contact is about
/// the origin and on the layer, the body below; symmetry in y = 0, the body at y >= 0; the base is
/// horizontal. Lengths below 1e-6 elements are zero. The contact may reach the sides.
/// Throws contact::InputError that names the face or element, its place, and the remedy; `name` is
/// what the message calls the mesh.
void verify(const HexMesh& mesh, const std::string& name);

}  // namespace tricontact::meshes
