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

/// gmsh 4.8 relies on some numbers of a file without a look: dimensions of physical names, types of
/// elements, in version 4.1 their nodes (cut to an int), in version 2.2 their partitions. True if
/// those are what they may be in an unpartitioned mesh of first or second order. False also for a
/// binary file that has the bytes of numbers in another order than this machine.
bool has_sound_numbers(std::string_view bytes, const MeshFormat& format);

}  // namespace tricontact::meshes
