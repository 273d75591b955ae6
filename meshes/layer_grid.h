#pragma once

#include <string_view>
#include <vector>

#include "meshes/layer_mesh.h"

namespace tricontact::meshes {

/// 1 + r + ... + r^(n-1), without the cancellation of (r^n - 1)/(r - 1) near r = 1.
double geometric_sum(int n, double r);
/// r in (0, growth] with geometric_sum(n, r) = total, to the last bit.
double growth_ratio(int n, double total, double growth);

/// Of growth along the surface, that downwards: slower, since strains vary most with the depth.
double depth_growth(double growth);

/// Edges that grow along a strip by a constant ratio.
struct Grading {
    int n = 0;          ///< number of elements; 0: no strip
    double ratio = 1;   ///< of an edge over the one before it [-]
    double length = 0;  ///< of the strip [m]
    /// Distances of the n + 1 nodes from the strip's beginning [m]: 0 ... length, exactly.
    std::vector<double> nodes() const;
};

/// Fewest elements over `length` [m] whose first edge is `first` [m] and whose ratio is at most
/// `growth` (>= 1). A strip not longer than `first` gets one element, no length none. Where edges
/// would shrink to less than 1/growth of the one before (short strips): one element if it is at
/// most growth * first long, else that number of equal ones, a little shorter than `first`.
Grading grade(double length, double first, double growth);

/// Number of elements that grade() makes, as a double: it may be beyond any int.
double graded_count(double length, double first, double growth);

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

/// The blocks between the planes of any such grid in gmsh's language, see layer_blocks.geo.
extern const std::string_view layer_blocks;

/// Throws contact::InputError naming the wrong length and the rule.
LayerGrid layer_grid(const LayerMeshSpec& spec);

}  // namespace tricontact::meshes
