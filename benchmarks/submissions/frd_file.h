#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/mesh_data.h"

namespace tricontact::benchmarks {

/// What an .frd file of CalculiX (ASCII) holds of its last state: a mesh for each material, with
/// DISP, STRESS and CONTACT at its nodes. Wedges of two degrees and slices, which axisymmetric and
/// plane elements are expanded to with OUTPUT=3D, become plane meshes again: r or x, and y.
struct FrdFile {
    std::vector<MeshData> meshes;    ///< with their materials as names
    std::vector<std::string> notes;  ///< what is not used
};
/// Throws contact::InputError.
FrdFile parse_frd(std::string_view text, const std::string& name);

}  // namespace tricontact::benchmarks
