#include "bem/influence.h"

#include <cmath>
#include <numbers>

namespace tricontact::bem {

namespace {

/// Antiderivatives in x and y of the kernels, s = sqrt(x^2 + y^2). Terms that cancel between the
/// corners of a rectangle are left out: y ln(x + s) = y asinh(x/|y|) + y ln|y|.
struct Corner {
    double one_over_s;  // 1/s
    double xx_over_s3;  // x^2/s^3
    double xy_over_s3;  // x y/s^3
    double x_over_s2;   // x/s^2
    double y_over_s2;   // y/s^2
};

double times_asinh(double factor, double x, double y) {
    return factor == 0 ? 0 : factor * std::asinh(x / std::abs(y));
}

/// int int x/(x^2+y^2) = y ln(s) + x atan(y/x), less the term linear in y.
double plane_kernel(double x, double y, double s) {
    const double logarithm = y == 0 ? 0 : y * std::log(s);
    return logarithm + (x == 0 ? 0 : x * std::atan(y / x));
}

Corner corner(double x, double y) {
    const double s = std::hypot(x, y);
    const double y_term = times_asinh(y, x, y), x_term = times_asinh(x, y, x);
    return {x_term + y_term, y_term, -s, plane_kernel(x, y, s), plane_kernel(y, x, s)};
}

}  // namespace

RectangleInfluence::RectangleInfluence(const contact::MaterialPair& materials, double width_x,
                                       double width_y)
    : half_x_(width_x / 2),
      half_y_(width_y / 2),
      symmetric_(materials.one_minus_nu_over_g() / (2 * std::numbers::pi)),
      skew_(materials.nu_over_g() / (2 * std::numbers::pi)),
      coupling_(materials.one_minus_two_nu_over_g() / (4 * std::numbers::pi)) {}

InfluenceCoefficients RectangleInfluence::at(double x, double y) const {
    const Corner a = corner(x + half_x_, y + half_y_), b = corner(x - half_x_, y + half_y_),
                 c = corner(x + half_x_, y - half_y_), d = corner(x - half_x_, y - half_y_);
    auto over_rectangle = [&](double Corner::*term) {
        return (a.*term - b.*term) - (c.*term - d.*term);
    };
    const double one = over_rectangle(&Corner::one_over_s);
    const double xx = over_rectangle(&Corner::xx_over_s3);
    const double xy = over_rectangle(&Corner::xy_over_s3);
    const double radial_x = coupling_ * over_rectangle(&Corner::x_over_s2);
    const double radial_y = coupling_ * over_rectangle(&Corner::y_over_s2);
    // y^2/s^3 = 1/s - x^2/s^3.
    return {.xx = symmetric_ * one + skew_ * xx,
            .xy = skew_ * xy,
            .yy = symmetric_ * one + skew_ * (one - xx),
            .xz = -radial_x,
            .yz = -radial_y,
            .zx = radial_x,
            .zy = radial_y,
            .zz = symmetric_ * one};
}

}  // namespace tricontact::bem
