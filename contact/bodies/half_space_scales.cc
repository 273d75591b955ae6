#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/bodies/ellipsoid.h"
#include "contact/bodies/line_contact_scales.h"
#include "contact/bodies/rough_scales.h"
#include "contact/case.h"
#include "contact/error.h"
#include "contact/solvers/increasing_root.h"

namespace tricontact::contact {

namespace {

double shift_ratio(const Case& c) {
    const MaterialPair materials = c.materials();
    return c.friction_coefficient * materials.effective_modulus() /
           materials.effective_shear_modulus();
}

// Hertz (1882); Johnson (1985), ch. 4: a^2 = R d, F_N = 4/3 E* sqrt(R) d^(3/2).
HalfSpaceScales hertz_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus();
    const double radius = c.indenter.radius;
    const double d =
        c.load.indentation
            ? *c.load.indentation
            : std::pow(3 * *c.load.normal_force / (4 * e_star * std::sqrt(radius)), 2. / 3);
    const double a = std::sqrt(radius * d);
    return {.contact_radius = a,
            .indentation = d,
            .normal_force = 4. / 3 * e_star * std::sqrt(radius) * std::pow(d, 1.5),
            .peak_pressure = 2 / std::numbers::pi * e_star * std::sqrt(d / radius),
            .unit_shift = shift_ratio(c) * d,
            .half_widths = {a, a}};
}

// The centre moves under the traction mu p along x by Cerruti's solution, Johnson (1985), section
// 3.6: mu/(2 pi) ∫ p [((1-nu)/G)/s + (nu/G) x^2/s^3] dA. Of Hertz' pressure the second integral is
// a_x^2/(2 R_x d) of the first, so that U_max = mu [d + (E*/G* - 1) a_x^2/R_x]; on a circle a_x^2
// is R d.
HalfSpaceScales elliptic_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus();
    const double radius = c.indenter.radius;
    const double ratio = ellipse_ratio(radius, c.indenter.radius_y);
    // Of the half axis 1 m; d goes with its square, F_N with its cube.
    const EllipticContact unit = elliptic_contact(radius, ratio, 1);
    const double a_x = c.load.indentation
                           ? std::sqrt(*c.load.indentation / unit.indentation)
                           : std::cbrt(*c.load.normal_force / e_star / unit.normal_force);
    const EllipticContact e = elliptic_contact(radius, ratio, a_x);
    const double excess = shift_ratio(c) - c.friction_coefficient;
    return {.contact_radius = std::sqrt(e.semi_axes[0] * e.semi_axes[1]),
            .indentation = e.indentation,
            .normal_force = e_star * e.normal_force,
            .peak_pressure = e_star * e.peak_pressure,
            .unit_shift = c.friction_coefficient * e.indentation + excess * a_x * a_x / radius,
            .half_widths = e.semi_axes};
}

/// The contact radius a [m] under the case's load.
double contact_radius(const Case& c, const AxisymmetricIndenter& body) {
    const double rim = body.outer_radius();
    const auto found =
        c.load.indentation
            ? increasing_root([&](double a) { return body.plane_profile(a) - *c.load.indentation; },
                              *c.load.indentation, rim)
            : increasing_root(
                  [&, area = *c.load.normal_force / c.materials().effective_modulus()](double a) {
                      return body.pressed_area(a) - area;
                  },
                  std::sqrt(*c.load.normal_force / c.materials().effective_modulus()), rim);
    if (found) return *found;
    throw InputError(fmt::format(
        "indenter: the contact reaches the rim of its profile at {:.6g} m; reduce the load or "
        "enlarge the indenter",
        rim));
}

// Sneddon (1965); U_max = mu (E*/G*) d of every body of revolution: Ciavarella (1998), Jaeger
// (1995).
HalfSpaceScales axisymmetric_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus();
    const auto body = c.make_axisymmetric_indenter();
    const double a = contact_radius(c, *body), d = body->plane_profile(a);
    const double force = e_star * body->pressed_area(a);
    const double centre = e_star * body->centre_pressure(a);
    return {.contact_radius = a,
            .indentation = d,
            .normal_force = force,
            .peak_pressure = std::isfinite(centre) ? centre : force / (std::numbers::pi * a * a),
            .unit_shift = shift_ratio(c) * d,
            .half_widths = {a, a}};
}

}  // namespace

HalfSpaceScales half_space_scales(const Case& c) {
    if (is_nominally_flat(c)) return rough_scales(c);
    if (c.is_cylindrical()) return line_contact_scales(c);
    switch (c.indenter.shape) {
        case Case::Shape::paraboloid:
        case Case::Shape::sphere:
            return hertz_scales(c);
        case Case::Shape::ellipsoid:
            return elliptic_scales(c);
        default:
            return axisymmetric_scales(c);
    }
}

}  // namespace tricontact::contact
