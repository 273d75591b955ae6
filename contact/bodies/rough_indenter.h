#pragma once

#include <memory>

#include "contact/bodies/height_map.h"
#include "contact/bodies/indenter.h"

namespace tricontact::contact {

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

    double height(double x, double y) const override;
    Vector2 slope(double x, double y) const override;

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
    Vector2 slope(double x, double y) const override;

  private:
    HeightField field_;
    Vector2 first_, last_;  // outermost nodes [m]
    double lowest_;
};

/// The same map with its middle node moved to node (0, 0): what RoughIndenter makes of it lies as
/// MappedIndenter does.
HeightMap from_middle(const HeightMap& map);

}  // namespace tricontact::contact
