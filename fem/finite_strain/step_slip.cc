#include "fem/finite_strain/step_slip.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>

// Where the indenter's material point that touched x is now (IndenterMotion), less where x is now,
// in the plane of the present surface. The pair of points has two normals: that of the present
// surface, n, and that of the indenter where it touched, turned with it, n'. The part of the way
// along n + n' is no slip; for n = n' that is the gap. It is symmetric in both instants: the same
// way back gives the opposite slip.
//
// A point that was open begins to slip when it is touched: the pose on the way at which its gap
// closes is found by a root (`touching`), with rolling and indentation in proportion.

namespace tricontact::fem {

using contact::Vector2;

namespace {

Pose between(const Pose& from, const Pose& to, double share) {
    Pose pose = from;
    pose.offset = from.offset + share * (to.offset - from.offset);
    pose.indentation += share * (to.indentation - from.indentation);
    return pose;
}

double gap(const contact::Indenter& indenter, const Pose& pose, const Vector3& x) {
    const Vector2 lowest = pose.lowest_point();
    return indenter.height(x[0] - lowest[0], x[1] - lowest[1]) + x[2] - pose.indentation;
}

/// Where on its way from one pose to the other the indenter meets x; at its end if it does not.
Pose touching(const contact::Indenter& indenter, const Pose& from, const Pose& to,
              const Vector3& x) {
    const auto left = [&](double share) { return gap(indenter, between(from, to, share), x); };
    const double first = left(0), last = left(1);
    if (!(first > 0)) return from;
    if (!(last < 0)) return between(from, to, 1);
    constexpr int bits = 40;
    std::uintmax_t evaluations = 50;
    const auto [low, high] = boost::math::tools::toms748_solve(
        left, 0., 1., first, last, boost::math::tools::eps_tolerance<double>(bits), evaluations);
    return between(from, to, low);
}

Vector3 normal_at(const contact::Indenter& indenter, const Pose& pose, const Vector3& x) {
    const Vector2 at = Vector2{x[0], x[1]} - pose.lowest_point();
    if (!std::isfinite(indenter.height(at[0], at[1]))) return {0, 0, 1};
    const Vector2 g = indenter.slope(at[0], at[1]);
    const double length = std::sqrt(1 + contact::dot(g, g));
    return {g[0] / length, g[1] / length, 1 / length};
}

}  // namespace

StepSlip::StepSlip(const contact::Indenter& indenter, double rolling_radius, const Start& start,
                   const Pose& now) {
    for (std::size_t i = 0; i < start.position.size(); ++i) {
        const Vector3& x = start.position[i];
        const Pose from =
            start.pressure[i] > 0 ? start.pose : touching(indenter, start.pose, now, x);
        const IndenterMotion motion(from, now, rolling_radius);
        touched_.push_back(motion.after(x));
        normal_.push_back(motion.turned(normal_at(indenter, from, x)));
    }
}

Vector2 StepSlip::at(std::size_t i, const ContactFrames& frames, const Vector3& x) const {
    const Vector3 n = frames.normal(i), &turned = normal_[i], &to = touched_[i];
    Vector3 way{to[0] - x[0], to[1] - x[1], to[2] - x[2]};
    const double along = dot(n, way) / (1 + dot(n, turned));
    for (int a = 0; a < 3; ++a) way[a] -= along * (n[a] + turned[a]);
    return frames.along_surface(i, way);
}

}  // namespace tricontact::fem
