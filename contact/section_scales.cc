#include "contact/section_scales.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/root.h"

namespace tricontact::contact {

namespace {

using std::numbers::pi;

double shift_over_depth(const Case& c) {
    return c.friction.law()->coulomb().value_or(1) * c.materials().effective_modulus() /
           c.materials().effective_shear_modulus();
}

HalfSpaceScales hole_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus(), radius = c.relative_radius();
    const double length = c.indenter.length;
    const double of_load = c.load.normal_force
                               ? line_half_width(*c.load.normal_force / length, radius, e_star)
                               : std::sqrt(2 * radius * *c.load.indentation);
    const double a = std::min(of_load, c.indenter.radius);
    const double force = c.load.normal_force.value_or(pi * e_star * a * a / (4 * radius) * length);
    const double d = c.load.indentation.value_or(2 * force / (pi * e_star * length));
    return {.contact_radius = a,
            .indentation = d,
            .normal_force = force,
            .peak_pressure = 2 * force / (pi * a * length),
            .unit_shift = shift_over_depth(c) * d,
            .half_widths = {a, length / 2}};
}

HalfSpaceScales flat_punch_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus(), b = c.indenter.flat_radius;
    const double stiffness = 2 * e_star * b;
    const double d = c.load.indentation ? *c.load.indentation : *c.load.normal_force / stiffness;
    return {.contact_radius = b,
            .indentation = d,
            .normal_force = stiffness * d,
            .peak_pressure = stiffness * d / (pi * b * b),
            .unit_shift = shift_over_depth(c) * d,
            .half_widths = {b, b}};
}

/// F R/(E* L) of the half width a >= b under a punch with rounded edges [m^2].
double rounded_load(double b, double a) {
    const double angle = std::asin(b / a);
    return a * a * (pi / 2 - angle - std::sin(angle) * std::cos(angle)) / 2;
}

/// d of the force per E* L: the mean of -ln|x| under 1/sqrt(a^2 - x^2) is ln 2 - ln a.
double depth_of(double force, double a, double length) {
    return 2 * force / pi * (std::numbers::ln2 + std::log(length / a));
}

double long_half_width(const Case& c) {
    const Case::IndenterData& body = c.indenter;
    const double b = body.flat_radius;
    if (body.shape == Case::Shape::flat_punch) return b;
    const double wanted =
        c.load.normal_force
            ? *c.load.normal_force * body.radius / (c.materials().effective_modulus() * body.length)
            : *c.load.indentation;
    const auto excess = [&](double beyond) {
        const double load = rounded_load(b, b + beyond);
        const double reached =
            c.load.normal_force ? load : depth_of(load / body.radius, b + beyond, body.length);
        return reached / wanted - 1;
    };
    const auto found = increasing_root(excess, b / 8, body.length);
    if (found) return b + *found;
    throw InputError("load: the punch's contact would be wider than it is long; reduce it");
}

HalfSpaceScales long_punch_scales(const Case& c) {
    const double e_star = c.materials().effective_modulus(), length = c.indenter.length;
    const double a = long_half_width(c);
    const double force = c.load.normal_force.value_or(c.load.indentation.value_or(0) * e_star *
                                                      length / depth_of(1, a, length));
    const double d = depth_of(force / (e_star * length), a, length);
    return {.contact_radius = a,
            .indentation = d,
            .normal_force = force,
            .peak_pressure = force / (2 * a * length),
            .unit_shift = shift_over_depth(c) * d,
            .half_widths = {a, length / 2}};
}

}  // namespace

bool is_section_alone(const Case& c) {
    return c.has_hole() || c.indenter.shape == Case::Shape::flat_punch ||
           c.indenter.is_long_punch();
}

HalfSpaceScales section_scales(const Case& c) {
    if (c.has_hole()) return hole_scales(c);
    return c.indenter.is_long_punch() ? long_punch_scales(c) : flat_punch_scales(c);
}

}  // namespace tricontact::contact
