#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.h"

namespace tricontact::benchmarks {

/// Size of a mesh in its contact [m]: as its file says, else the median distance of neighbouring
/// points. `unit`: of positions and of a stated size without unit [m].
double mesh_size(const MeshField& field, const MeshResult& mesh, double unit);

/// Whether meshes are one family: each finer than the one before by nearly the same share in every
/// direction, which their numbers of points in the contact, and of elements where files say them,
/// show.
struct MeshFamily {
    bool is_family = false;
    std::string why_not;  ///< a sentence with the numbers
    /// Where the edge of the contact stands between two points, in spacings, mesh by mesh [0, 1).
    std::vector<double> edge_places;
    bool edges_alike = false;
};
MeshFamily mesh_family(const Submission& submission, const std::vector<MeshResult>& meshes,
                       const Reference& reference);

}  // namespace tricontact::benchmarks
