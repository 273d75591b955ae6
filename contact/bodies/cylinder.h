#pragma once

#include <algorithm>

#include "contact/base/error.h"
#include "contact/bodies/indenter.h"

namespace tricontact::contact {

/// h = x^2 / (2 R) for |y| <= L/2, infinite beyond: what Hertz' theory calls a cylinder, its axis
/// along y. Ends may be rounded by a radius r: h = x^2 / (2 R) + r - sqrt(r^2 - s^2) at the
/// distance s from the straight part, which is L - 2 r long.
class Cylinder final : public Indenter {
  public:
    /// Lengths in m; chamfer: r, 0 of sharp ends. Throws InputError unless R and L are positive and
    /// finite and 0 <= r <= L/2.
    Cylinder(double radius, double length, double chamfer = 0)
        : radius_(radius), length_(length), chamfer_(chamfer) {
        if (!is_positive_and_finite(radius))
            throw InputError("indenter: the radius must be positive and finite");
        if (!is_positive_and_finite(length))
            throw InputError("indenter: the length must be positive and finite");
        if (!(chamfer >= 0 && chamfer <= length / 2))
            throw InputError("indenter: the chamfer must lie between 0 and half the length");
    }

    double height(double x, double y) const override {
        if (std::abs(y) > length_ / 2) return infinity;
        // s^2 / (r + sqrt(r^2 - s^2)): no cancellation at small s
        const double s = rounded_distance(y), r = chamfer_;
        return x * x / (2 * radius_) + (s > 0 ? s * s / (r + std::sqrt(r * r - s * s)) : 0);
    }
    /// Finite where the end's rounding is vertical: nothing touches there.
    Vector2 slope(double x, double y) const override {
        constexpr double steepest = 1e6;
        const double s = rounded_distance(y), rest = std::sqrt(chamfer_ * chamfer_ - s * s);
        const double steep = s > 0 ? s / std::max(rest, s / steepest) : 0;
        return {x / radius_, std::copysign(steep, y)};
    }

  private:
    // s [m]; 0 on the straight part
    double rounded_distance(double y) const {
        return std::clamp(std::abs(y) - (length_ / 2 - chamfer_), 0., chamfer_);
    }

    double radius_, length_, chamfer_;
};

}  // namespace tricontact::contact
