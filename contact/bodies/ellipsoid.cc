#include "contact/bodies/ellipsoid.h"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/root.h"

namespace tricontact::contact {

Ellipsoid::Ellipsoid(double radius_x, double radius_y) : radius_x_(radius_x), radius_y_(radius_y) {
    if (!is_positive_and_finite(radius_x) || !is_positive_and_finite(radius_y))
        throw InputError("indenter: both radii of an ellipsoid must be positive and finite");
}

double ellipse_ratio(double radius_x, double radius_y) {
    using boost::math::ellint_rd;
    if (radius_x == radius_y) return 1;
    // k^2 R_D(0, 1, k^2)/R_D(0, k^2, 1) over k, logarithms: increasing from -inf to inf.
    const double wanted = std::log(radius_y / radius_x);
    auto excess = [=](double log_k) {
        const double square = std::exp(2 * log_k);
        return std::log(ellint_rd(0., square, 1.) / ellint_rd(0., 1., square)) - wanted;
    };
    // The ratio lies between the root of R_y/R_x and R_y/R_x itself.
    constexpr double margin = 1e-6;  // rounding, of nearly equal radii
    const double low = std::min(wanted / 2, wanted) - margin;
    const double high = std::max(wanted / 2, wanted) + margin;
    return std::exp(bracketed_root(excess, low, high));
}

EllipticContact elliptic_contact(double radius_x, double ratio, double semi_axis_x) {
    const double a_x = semi_axis_x, a_y = ratio * semi_axis_x;
    // Of the circle or ellipse of a_x = 1; both integrals are homogeneous.
    const double r_f = boost::math::ellint_rf(0., 1., ratio * ratio);
    const double r_d = boost::math::ellint_rd(0., ratio * ratio, 1.);
    const double p0 = 3 * a_x / (2 * radius_x * ratio * r_d);
    return {.semi_axes = {a_x, a_y},
            .indentation = p0 * a_y * r_f,
            .normal_force = 2. / 3 * std::numbers::pi * a_x * a_y * p0,
            .peak_pressure = p0};
}

}  // namespace tricontact::contact
