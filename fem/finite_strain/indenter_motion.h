#pragma once

#include <array>
#include <cmath>

#include "contact/base/vector2.h"

// Rolling of a rigid indenter, seen along the axis; R: radius of rolling, W: change of the offset.
//
//         axis o  ------ W ----->  o          angle W/R about the axis: the material point that was
//              |                  /|          lowest lies R sin(W/R) behind the new one, and higher
//              | R            R  / |          by R (1 - cos(W/R))
//              |                /  |
//    z v  -----*---------------*---*-----     shift and change of d are translations on top

namespace tricontact::fem {

// Of vectors in the plane.
using contact::operator+, contact::operator-, contact::operator*, contact::operator/;
using contact::dot;

/// x, y and into the substrate, as contact sees directions.
using Vector3 = std::array<double, 3>;
inline double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Where the rigid indenter is.
struct Pose {
    contact::Vector2 offset{}, shift{};  ///< W of the rolling, U [m]
    double indentation = 0;              ///< d [m]

    contact::Vector2 lowest_point() const { return offset + shift; }
};

/// The rigid motion of the indenter in a step: it rolls without slip by the change of its offset, a
/// rotation about the axis that lies its radius above its lowest point, and is moved by those of
/// its shift and its indentation.
class IndenterMotion {
  public:
    /// `radius` [m]: of the rolling; infinite: it does not rotate.
    IndenterMotion(const Pose& from, const Pose& to, double radius) : from_(from), to_(to) {
        const contact::Vector2 way = to.offset - from.offset;
        const double length = contact::norm(way), angle = length / radius;
        if (angle == 0) return;
        direction_ = way / length;
        radius_ = radius;
        cosine_ = std::cos(angle);
        sine_ = std::sin(angle);
    }

    /// Where its material point is now that was at `x` before the step [m].
    Vector3 after(const Vector3& x) const {
        const contact::Vector2 now = to_.lowest_point(), then = from_.lowest_point();
        const Vector3 r =
            turned({x[0] - then[0], x[1] - then[1], x[2] - from_.indentation + radius_});
        return {now[0] + r[0], now[1] + r[1], to_.indentation - radius_ + r[2]};
    }
    /// What a direction in it has become.
    Vector3 turned(const Vector3& r) const {
        const double along = contact::dot({r[0], r[1]}, direction_);
        const double by = (cosine_ - 1) * along - sine_ * r[2];
        return {r[0] + by * direction_[0], r[1] + by * direction_[1],
                cosine_ * r[2] + sine_ * along};
    }

  private:
    Pose from_, to_;
    contact::Vector2 direction_{1, 0};
    double radius_ = 0, cosine_ = 1, sine_ = 0;
};

}  // namespace tricontact::fem
