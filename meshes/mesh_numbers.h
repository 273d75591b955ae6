#pragma once

#include <string>
#include <string_view>

namespace tricontact::meshes {

/// First line after $MeshFormat.
struct MeshFormat {
    std::string_view version;
    bool binary = false;
};
MeshFormat mesh_format(std::string_view bytes);

/// gmsh 4.8 uses two kinds of numbers of a file as indices without a look: dimensions of physical
/// names, and nodes of elements (version 4.1), cut to an int. True if those are what they may be.
/// False also for a binary file with the bytes of numbers in another order than this machine's.
bool has_sound_numbers(std::string_view bytes, const MeshFormat& format);

}  // namespace tricontact::meshes
