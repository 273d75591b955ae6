#pragma once

#include <array>
#include <vector>

#include "contact/history.h"
#include "contact/surface.h"

namespace tricontact::comparisons {

/// Whether the points of a surface form a regular grid in the contact plane.
bool is_grid(const contact::Surface& surface);

/// Resamples surfaces whose nodes form no grid (layout `nodes`, n_x = 0) onto one. Every nine-node
/// quadrilateral counts as four of four nodes each, inside which fields are bilinear; states are
/// those of the nearest node. Outside all of them there is neither contact nor traction, and
/// displacements and gap are NaN.
class Resampling {
  public:
    /// A grid with a point at the origin, about as fine as the nodes, around those of `surface`.
    explicit Resampling(const contact::Surface& surface);

    /// The surface this was made from, or another on the same nodes, as layout `grid`.
    contact::Surface operator()(const contact::Surface& surface) const;

  private:
    /// What a grid point is made from; `covered` only inside a quadrilateral.
    struct Source {
        std::array<int, 4> nodes{};
        std::array<double, 4> weights{};
        int nearest = 0;
        bool covered = false;
    };

    void rasterise(const contact::Surface& surface, const std::array<int, 4>& quad);
    std::vector<double> sampled(const std::vector<double>& values, double outside) const;

    contact::Surface frame_;  // grid without fields
    std::vector<Source> sources_;
};

/// With all surfaces resampled that are neither grids nor lines, as plots need them.
std::vector<contact::History> on_grids(std::vector<contact::History> histories);

}  // namespace tricontact::comparisons
