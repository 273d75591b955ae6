#pragma once

#include <array>
#include <functional>
#include <vector>

#include "meshes/hex_mesh.h"

// Of bodies that are meshed in layers below a surface: a regular patch about the middle, and rings
// around it that end on a circle.

namespace tricontact::meshes {

/// Lines of quadrilaterals, a square in number and a circle in shape. Lengths in m.
struct DiscSpec {
    double size = 0;                  ///< edge in the patch, along x and y
    double patch_x = 0, patch_y = 0;  ///< half sides of the patch; whole numbers of `size`
    double rim = 0;                   ///< way from the middle to the circle
    double growth = 1.8;              ///< of neighbouring elements, outwards
    bool half_model = false;          ///< y >= 0 only
    /// Way along the surface to the distance from the axis, and back.
    std::function<double(double)> way, distance;
};

/// x and y of the nodes, and the quadrilaterals between them.
class DiscSurface {
  public:
    explicit DiscSurface(const DiscSpec& spec);

    int n_nodes() const { return static_cast<int>(nodes_.size()); }
    const std::array<double, 2>& node(int n) const { return nodes_[n]; }
    /// Nodes anticlockwise, seen from outside.
    const std::vector<std::array<int, 4>>& quads() const { return quads_; }
    /// Whether a quadrilateral is in the patch.
    bool in_patch(std::size_t quad) const { return in_patch_[quad]; }
    /// Those on the circle, anticlockwise; of a half from y = 0 to y = 0, else closed by itself.
    const std::vector<int>& circle() const { return circle_; }

  private:
    std::vector<std::array<double, 2>> nodes_;
    std::vector<std::array<int, 4>> quads_;
    std::vector<bool> in_patch_;
    std::vector<int> circle_;
};

/// Hexahedra in layers: node `s` of the surface in layer m, 0 the farthest from it, is
/// `place(s, m)`. Quadrilaterals of the first layer are the base; of the last the contact where
/// `in_contact`, else sides; edges of one quadrilateral are sides, or of the plane of symmetry
/// where both ends have y = 0.
HexMesh in_layers(const std::vector<std::array<int, 4>>& quads, const std::vector<bool>& in_contact,
                  int n_surface, int n_layers, const std::function<Point(int, int)>& place);

}  // namespace tricontact::meshes
