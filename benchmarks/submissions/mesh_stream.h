#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/mesh_data.h"

namespace tricontact::benchmarks {

/// What the program that reads by VTK answers.
struct MeshAnswer {
    std::string error;               ///< empty: the file was read
    std::vector<MeshData> meshes;    ///< arrays with a known meaning alone
    std::vector<std::string> notes;  ///< "array material is not used"
};

/// As bytes of this machine.
std::string written(const MeshAnswer& answer);
/// False where the bytes are not what `written` makes of consistent meshes.
bool read_answer(std::string_view bytes, MeshAnswer& answer);

}  // namespace tricontact::benchmarks
