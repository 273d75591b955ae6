#include "theory/layer/free_sides.h"

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/base/root.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

double square(double x) {
    return x * x;
}

/// What is left of the decay far away, of disc and strip: fitted.
double far_disc(double nu) {
    return square(.42 - 2.35 * nu + 1.88 * nu * nu) + .002;
}
double far_strip(double nu) {
    return square(.38 - 2.02 * nu + .9 * nu * nu) + .002;
}

/// Mean of I0(z r/a) over Hertz' pressure on a disc.
double mean_over_disc(double z) {
    if (z < .01) return 1 + z * z / 10;  // the next term is z^4/280
    return 3 * (z * std::cosh(z) - std::sinh(z)) / (z * z * z);
}

/// Mean of cosh(z x/a) over Hertz' pressure on a strip.
double mean_over_strip(double z) {
    return z < 1e-8 ? 1 : 2 * boost::math::cyl_bessel_i(1, z) / z;
}

/// From the centre of a block to its side in a direction, of the side ahead and the one to the
/// left or right.
double distance(const BlockSides& sides, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    constexpr double far = std::numeric_limits<double>::infinity();
    const double along = c > 0 ? sides.right / c : c < 0 ? sides.left / -c : far;
    const double across = s > 0 ? sides.front / s : s < 0 ? sides.back / -s : far;
    return std::min(along, across);
}

}  // namespace

double edge_decay(double poisson) {
    const double kappa = 3 - 4 * poisson;
    return contact::bracketed_root(
        [kappa](double x) { return x * x - square(kappa - 1) / 4 - kappa * square(std::cos(x)); },
        0, (kappa + 1) / 2);
}

double disc_side_compliance(double poisson, double t) {
    const double column = 1 / (2 * pi * (1 + poisson) * t * t);
    return std::exp(-2 * edge_decay(poisson) * t) * std::hypot(column, far_disc(poisson));
}

double strip_side_compliance(double poisson, double t) {
    const double column = (1 - poisson) / (4 * t * (1 + 2 * t));
    return std::exp(-2 * edge_decay(poisson) * t) * std::hypot(column, far_strip(poisson));
}

double side_effect(const ElasticLayer& layer, const LayerContact& contact,
                   const BlockSides& sides) {
    constexpr int n_directions = 360;
    const double nu = layer.material.poisson, b = layer.thickness;
    double mean = 0;
    for (int i = 0; i < n_directions; ++i)
        mean += disc_side_compliance(nu, distance(sides, 2 * pi * (i + .5) / n_directions) / b) /
                n_directions;
    const double spread = mean_over_disc(edge_decay(nu) * contact.contact_radius / b);
    return block_margin * contact.normal_force * mean * square(spread) /
           (layer.material.shear_modulus() * b * contact.indentation);
}

double side_effect(const ElasticLayer& layer, const LineContact& contact, double right,
                   double left) {
    const double nu = layer.material.poisson, b = layer.thickness;
    const double mean =
        (strip_side_compliance(nu, right / b) + strip_side_compliance(nu, left / b)) / 2;
    const double spread = mean_over_strip(edge_decay(nu) * contact.half_width / b);
    return strip_margin * contact.load * mean * square(spread) /
           (layer.material.shear_modulus() * contact.indentation);
}

}  // namespace tricontact::theory
