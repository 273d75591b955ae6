#pragma once

#include <memory>
#include <string>

#include "files/regular_file.h"

namespace tricontact::meshes {

/// gmsh takes any text for a script and runs it, overlooks a missing end of a mesh, and crashes on
/// numbers that it does not expect. So before it sees a file: throws contact::InputError unless it
/// can be read, begins as a mesh of version 2.2 or 4.1, has all of its nodes and elements, and
/// sound numbers in them.
std::unique_ptr<files::RegularFile> open_mesh_file(const std::string& path);

/// Whether the sections of nodes and elements are there to their ends; false for no such file.
bool is_complete_mesh(const std::string& path);

}  // namespace tricontact::meshes
