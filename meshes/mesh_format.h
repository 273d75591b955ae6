#pragma once

#include <string>
#include <string_view>

#include "files/regular_file.h"

namespace tricontact::meshes {

/// gmsh takes any text for a script and runs it, overlooks a missing end of a mesh, and crashes on
/// numbers that it does not expect. So before it sees the file: throws contact::InputError unless
/// what can be read of it from here on begins as a mesh of version 2.2 or 4.1, has all of its nodes
/// and elements, and sound numbers in them. `path` is for messages.
void check_mesh_file(files::RegularFile& file, const std::string& path);

/// Throws contact::InputError that says why the mesh file cannot be read.
[[noreturn]] void refuse_mesh_file(const std::string& path, const files::Unreadable& why);

/// Whether the sections of nodes and elements are there to their ends; false for no such file.
bool is_complete_mesh(const std::string& path);

/// First line after $MeshFormat.
struct MeshFormat {
    std::string_view version;
    bool binary = false;
};
MeshFormat mesh_format(std::string_view bytes);

/// gmsh 4.8 relies on some numbers of a file without a look: dimensions of physical names, types of
/// elements, in version 4.1 their nodes (cut to an int), in version 2.2 their partitions. True if
/// those are what they may be in an unpartitioned mesh of first or second order. False also for a
/// binary file that has the bytes of numbers in another order than this machine.
bool has_sound_numbers(std::string_view bytes, const MeshFormat& format);

/// gmsh's types of elements.
inline constexpr int hexahedron = 5, quadrilateral = 3;

}  // namespace tricontact::meshes
