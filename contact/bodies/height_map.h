#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "contact/base/vector2.h"
#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// Heights of a surface on the nodes of a regular lattice.
struct HeightMap {
    int n_x = 0, n_y = 0;
    Vector2 spacing{};           ///< of the nodes [m]
    std::vector<double> height;  ///< z out of the substrate [m], from any level; x runs fastest
    std::string layout = {};     ///< what its file was taken for: "x y z of each node"

    double at(int i, int j) const { return height[static_cast<std::size_t>(j) * n_x + i]; }
    double& at(int i, int j) { return height[static_cast<std::size_t>(j) * n_x + i]; }
    /// Of a map that repeats itself, n_x by n_y nodes [m].
    Vector2 period() const { return {n_x * spacing[0], n_y * spacing[1]}; }
};

/// Heights and slopes between the nodes. Bilinear: continuous, so a body that rolls by parts of a
/// cell does not jump, bounded by the nodes' heights, and on the nodes exact, so a map and cells of
/// one spacing meet without interpolation.
class HeightField {
  public:
    /// Throws InputError unless there are 2 x 2 finite heights at least and the spacing is positive
    /// and finite.
    explicit HeightField(HeightMap map);

    const HeightMap& map() const { return map_; }
    /// Height [m] of the repeating map, whose node (0, 0) is at the origin, and its gradient within
    /// a cell [-].
    struct Place {
        double height;
        Vector2 slope;
    };
    Place at(double x, double y) const;

  private:
    HeightMap map_;
};

/// Root mean square of the heights over their mean [m].
double rms_height(const HeightMap& map);
/// Root mean square of the gradient, from differences of neighbouring nodes [-].
double rms_slope(const HeightMap& map);

/// An infinite plane, h = 0.
class Plane final : public Indenter {
  public:
    double height(double, double) const override { return 0; }
    Vector2 slope(double, double) const override { return {0, 0}; }
};

/// A body with a repeating height map upon its surface, node (0, 0) at the body's origin. Heights
/// count from the lowest of the body over the map's nodes: between them a curved body may lie lower
/// by what it curves within a cell.
class RoughIndenter final : public Indenter {
  public:
    RoughIndenter(std::unique_ptr<const Indenter> body, HeightMap roughness);

    double height(double x, double y) const override {
        return body_->height(x, y) + roughness_.at(x, y).height - lowest_;
    }
    Vector2 slope(double x, double y) const override {
        return body_->slope(x, y) + roughness_.at(x, y).slope;
    }
    Vector2 lowest_point() const override { return body_->lowest_point(); }

  private:
    double find_lowest() const;

    std::unique_ptr<const Indenter> body_;
    HeightField roughness_;
    double lowest_;
};

/// A measured piece of a surface, its middle node (n_x/2, n_y/2) at the origin, heights from the
/// lowest node: infinity beyond the outermost nodes.
class MappedIndenter final : public Indenter {
  public:
    explicit MappedIndenter(HeightMap map);

    double height(double x, double y) const override;
    Vector2 slope(double x, double y) const override {
        return field_.at(x - first_[0], y - first_[1]).slope;
    }
    /// The lowest node; the mean place of several that are equally low.
    Vector2 lowest_point() const override { return lowest_point_; }

  private:
    Vector2 find_lowest_point() const;

    HeightField field_;
    Vector2 first_, last_;  // outermost nodes [m]
    Vector2 lowest_point_;
    double lowest_;
};

/// The same map with its middle node moved to node (0, 0): what RoughIndenter makes of it lies as
/// MappedIndenter does.
HeightMap from_middle(const HeightMap& map);

}  // namespace tricontact::contact
