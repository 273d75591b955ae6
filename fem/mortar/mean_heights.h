#pragma once

#include <memory>

#include "contact/bodies/indenter.h"

namespace tricontact::fem {

/// A rigid body as the points of a pressure grid see it: means of its height by their bilinear
/// functions, as displacements are (pressure_grid.h).
class MeanHeights final : public contact::Indenter {
  public:
    /// `spacing`: of the grid [m].
    MeanHeights(std::shared_ptr<const contact::Indenter> body, contact::Vector2 spacing)
        : body_(std::move(body)), spacing_(spacing) {}

    /// Of what the body has around the place; infinity where it has nothing there.
    double height(double x, double y) const override;
    contact::Vector2 slope(double x, double y) const override { return body_->slope(x, y); }
    contact::Vector2 lowest_point() const override { return body_->lowest_point(); }
    bool presses_like_a_ball() const override { return body_->presses_like_a_ball(); }

  private:
    std::shared_ptr<const contact::Indenter> body_;
    contact::Vector2 spacing_;
};

}  // namespace tricontact::fem
