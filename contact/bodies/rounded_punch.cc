#include "contact/bodies/rounded_punch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/error.h"
#include "contact/solvers/arc_moment.h"

namespace tricontact::contact {

RoundedPunch::RoundedPunch(double flat_radius, double radius)
    : flat_radius_(flat_radius), radius_(radius) {
    if (!(flat_radius > 0) || !std::isfinite(flat_radius) || !(radius > 0) ||
        !std::isfinite(radius))
        throw InputError("indenter: both radii of a rounded punch must be positive and finite");
}

double RoundedPunch::profile(double r) const {
    const double beyond = std::max(0., r - flat_radius_);
    return beyond * beyond / (2 * radius_);
}

double RoundedPunch::profile_slope(double r) const {
    return std::max(0., r - flat_radius_) / radius_;
}

double RoundedPunch::outer_radius() const {
    return std::numeric_limits<double>::infinity();
}

double RoundedPunch::slope_moment(double x, int k) const {
    if (x <= flat_radius_) return 0;
    return (arc_moment(x, flat_radius_, x, k + 1) -
            flat_radius_ * arc_moment(x, flat_radius_, x, k)) /
           radius_;
}

}  // namespace tricontact::contact
