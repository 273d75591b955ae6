#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/compliances/compliance.h"
#include "fem/mortar/pressure_grid.h"
#include "fem/mortar/surface_heights.h"

namespace tricontact::fem {

/// The gap between the surfaces of two bodies as a pressure grid sees it, the mean by the weights
/// of each point: height of an indenter that stands where it was meshed.
class SurfaceGap final : public contact::Indenter {
  public:
    explicit SurfaceGap(contact::ContactPoints grid) : grid_(std::move(grid)), gap_(grid_.size()) {}

    /// Adds `sign` times the heights of a surface.
    void add(const SurfaceHeights& surface, const PressureTransfer& transfer, double sign);

    /// The least distance of the surfaces [m], and where; from then on gaps count from it. `below`
    /// null: the plane z = 0.
    struct Least {
        double height;
        contact::Vector2 place;
    };
    Least let_down(const SurfaceHeights& above, const SurfaceHeights* below);

    const contact::ContactPoints& points() const { return grid_; }
    const std::vector<double>& at_points() const { return gap_; }

    /// Of the grid's point nearest to the place; infinity beside the grid.
    double height(double x, double y) const override;
    contact::Vector2 slope(double x, double y) const override;

  private:
    int nearest(int d, double x) const;
    double at(int i, int j) const { return gap_[static_cast<std::size_t>(j) * grid_.n_x + i]; }

    contact::ContactPoints grid_;
    std::vector<double> gap_;
};

}  // namespace tricontact::fem
