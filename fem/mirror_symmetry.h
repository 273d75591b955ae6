#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "fem/q2_space.h"

// Why it is worth looking for: mirror_symmetry.cc; what is done with it: body_parts.h.

namespace tricontact::fem {

/// How a body is its own mirror image in a plane x = const.
struct MirrorSymmetry {
    std::vector<int> image;         ///< of each node; on the plane it is the node itself
    std::vector<std::int8_t> side;  ///< of each node: -1, 0 (on the plane) or 1 (greater x)
    std::vector<int> half;          ///< cells on the side of greater x
};

/// Empty unless every node, cell with its region and boundary face with its name has its mirror
/// image within rounding, and no cell lies on both sides.
std::optional<MirrorSymmetry> mirror_symmetry(const Q2Space& space);

}  // namespace tricontact::fem
