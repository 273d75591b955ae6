#pragma once

#include <string>

namespace tricontact::meshes {

/// gmsh takes any text for a script and runs it, and overlooks a missing end of a mesh. So before
/// it sees the file: throws contact::InputError unless the path is a readable regular file
/// `*.msh` that begins as a mesh of version 2.2 or 4.1 and has all of its nodes and elements.
void check_mesh_file(const std::string& path);

/// Whether the sections of nodes and elements are there to their ends. Throws
/// std::ios_base::failure if the file cannot be read.
bool is_complete_mesh(const std::string& path);

}  // namespace tricontact::meshes
