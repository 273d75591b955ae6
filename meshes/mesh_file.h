#pragma once

#include <string>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Reads a gmsh file whose physical groups have the names of Boundary and Region; `unit` [m] is the
/// length of 1 in the file. The mesh is verified. Throws contact::InputError: no such file, not a
/// mesh, other elements than straight hexahedra, unknown or missing names, and what verify() finds.
HexMesh read_mesh(const std::string& path, double unit);

/// Writes a gmsh 4.1 file in metres. Throws contact::InputError if that fails.
void write_mesh(const HexMesh& mesh, const std::string& path);

/// What a solver relies on: every boundary face has exactly one name, contact, free top and
/// symmetry lie in their planes, all Jacobians are positive, there is a contact and a base.
/// Throws contact::InputError that names the face or element, its place, and the remedy; `name` is
/// what the message calls the mesh.
void verify(const HexMesh& mesh, const std::string& name);

}  // namespace tricontact::meshes
