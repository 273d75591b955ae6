#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/submissions/submission.h"
#include "io/keys/key.h"

namespace tricontact::benchmarks {

/// Norms of a comparison that a tolerance may be given for, beside quantity_keys.
inline constexpr std::array<std::string_view, 11> norm_keys{
    "load_within",     "pressure_l2",     "pressure_l2_inside",   "pressure_max_inside",
    "edge_band",       "traction_l2",     "traction_load_within", "bound",
    "complementarity", "displacement_l2", "pressure_deviation"};

/// Most meshes of a submission.
inline constexpr int most_meshes = 8;

/// Keys of a submission file, those of a mesh under "mesh.".
const io::KeyList& submission_keys();

/// As read_submission, of a text; files that it names stand beside `name`.
Submission parse_submission(std::string_view text, const std::string& name);

/// Results of plain files: --case NAME A.csv B.csv. Coarse to fine by the sizes they state, else by
/// the distances of their points where there is contact. Throws contact::InputError.
Submission submission_of_files(const std::string& problem, const std::vector<std::string>& files);

/// Typical distance of the points that carry load, over their extent; 0 if fewer than two do. What
/// sorts meshes without stated sizes.
double relative_point_distance(const MeshField& field);

}  // namespace tricontact::benchmarks
