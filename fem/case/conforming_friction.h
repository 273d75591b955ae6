#pragma once

#include <cmath>
#include <memory>

#include "contact/friction/carried_friction.h"

namespace tricontact::fem {

/// Friction of a pin in a hole: `law` for the pressure along the radius of each point, where what
/// is pressed along z is p cos(theta) - t sin(theta), see planar::PairOptions::with_friction.
class ConformingFriction final : public contact::CarriedFriction {
  public:
    /// `radius` along whose arc x counts [m].
    ConformingFriction(std::shared_ptr<const contact::FrictionLaw> law, double radius)
        : law_(std::move(law)), radius_(radius) {}

    void bounds(const Points& points, std::span<double> bound) const override {
        bounds_beside(points, {}, bound);
    }
    void bounds_beside(const Points& points, std::span<const double> traction,
                       std::span<double> bound) const override;
    std::optional<double> coulomb() const override { return law_->coulomb(); }
    const contact::FrictionLaw& law() const { return *law_; }

    /// Pressure along the radius [Pa] of a point at x that carries these along z and the arc.
    static double radial_pressure(double along_z, double traction, double angle) {
        return (along_z + traction * std::sin(angle)) / std::cos(angle);
    }

  private:
    std::shared_ptr<const contact::FrictionLaw> law_;
    double radius_;
};

}  // namespace tricontact::fem
