#pragma once

#include <vector>

#include "meshes/layer_mesh.h"

namespace tricontact::meshes {

/// One direction of the tensor grid: strips between ascending planes, each divided in progression.
struct GridAxis {
    struct Strip {
        int n;         ///< elements
        double ratio;  ///< of an edge over the one before it, in ascending direction [-]
    };
    std::vector<double> planes;  ///< ends of the strips [m], ascending
    std::vector<Strip> strips;   ///< one less than planes
    std::vector<double> nodes;   ///< all nodes [m], ascending; contain the planes, bit by bit

    int n_elements() const { return static_cast<int>(nodes.size()) - 1; }
    int n_strips() const { return static_cast<int>(strips.size()); }
};

/// The nodes of a layer mesh, computed: see make_layer_mesh().
struct LayerGrid {
    std::array<GridAxis, 3> axes;                        ///< x, y, z
    int patch_x = 0, patch_y = 0;                        ///< strips of the patch
    int last_patch_y = 0;                                ///< of a graded patch, else patch_y
    int layer = 0;                                       ///< strip of the (upper) layer
    bool symmetric_low = false, symmetric_high = false;  ///< the faces at the least and greatest y
};

/// Throws contact::InputError naming the wrong length and the rule.
LayerGrid layer_grid(const LayerMeshSpec& spec);

}  // namespace tricontact::meshes
