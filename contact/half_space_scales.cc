#include "contact/half_space_scales.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/bodies/ellipsoid.h"
#include "contact/cells.h"
#include "contact/friction/radial_bound.h"
#include "contact/rig_stiffness.h"
#include "contact/section_scales.h"

namespace tricontact::contact {

namespace {

using std::numbers::pi;
constexpr double widest = 0.1;  // a/L of what is still a line contact

/// -ln|x|, averaged over Hertz' pressure of a = 1, and ln(L/a).
double centre_factor(double length_ratio) {
    return .5 + std::numbers::ln2 + std::log(length_ratio);
}

/// d = a^2/(2R) (1/2 + ln 2 + ln(L/a)).
double indentation_of(double half_width, const Case::IndenterData& body) {
    return half_width * half_width / (2 * body.radius) * centre_factor(body.length / half_width);
}

double half_width_of_indentation(double d, const Case::IndenterData& body) {
    const double largest = widest * body.length;
    const auto excess = [&](double a) { return indentation_of(a, body) / d - 1; };
    if (!(excess(largest) >= 0))
        throw InputError(
            "load.indentation: the cylinder's contact would be wider than a fifth of its length: "
            "no line contact; reduce it");
    // Monotone up to a = L exp(ln 2), and d < a^2/(2R) ln(...) leaves a root above zero.
    double low = largest;
    while (excess(low) > 0) low /= 2;
    return bracketed_root(excess, low, largest, root_bits - 1);
}

struct Spread {
    double height = 0, slope = 0;  // root mean squares [m], [-]
};

/// Map and roughness are independent of each other.
Spread spread(const Case::IndenterData& indenter) {
    Spread sum;
    if (const auto& map = indenter.height_map) sum = {rms_height(*map), rms_slope(*map)};
    if (const auto& r = indenter.roughness)
        sum = {std::hypot(sum.height, rms_height(*r)), std::hypot(sum.slope, r->rms_slope)};
    return sum;
}

/// mu of Coulomb's law; of another 1, to which mean_friction() are the factors.
double friction_of(const Case& c) {
    return c.friction.law()->coulomb().value_or(1);
}

double shift_ratio(const MaterialPair& materials, double coulomb_coefficient) {
    return coulomb_coefficient * materials.effective_modulus() /
           materials.effective_shear_modulus();
}
double shift_ratio(const Case& c) {
    return shift_ratio(c.materials(), friction_of(c));
}

// Hertz (1882); Johnson (1985), ch. 4: a^2 = R d, F_N = 4/3 E* sqrt(R) d^(3/2).
HalfSpaceScales hertz_scales_at(double d, double radius, const MaterialPair& materials,
                                double coulomb_coefficient) {
    const double e_star = materials.effective_modulus();
    const double a = std::sqrt(radius * d);
    return {.contact_radius = a,
            .indentation = d,
            .normal_force = 4. / 3 * e_star * std::sqrt(radius) * std::pow(d, 1.5),
            .peak_pressure = 2 / std::numbers::pi * e_star * std::sqrt(d / radius),
            .unit_shift = shift_ratio(materials, coulomb_coefficient) * d,
            .half_widths = {a, a}};
}

HalfSpaceScales hertz_scales(const Case& c) {
    const auto d = c.load.indentation;
    return d ? hertz_scales_at(*d, c.indenter.radius, c.materials(), friction_of(c))
             : hertz_scales(c.materials(), c.indenter.radius, *c.load.normal_force, friction_of(c));
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
    const double excess = shift_ratio(c) - friction_of(c);
    return {.contact_radius = std::sqrt(e.semi_axes[0] * e.semi_axes[1]),
            .indentation = e.indentation,
            .normal_force = e_star * e.normal_force,
            .peak_pressure = e_star * e.peak_pressure,
            .unit_shift = friction_of(c) * e.indentation + excess * a_x * a_x / radius,
            .half_widths = e.semi_axes};
}

/// The contact radius a [m] under the case's load.
double contact_radius(const Case& c, const AxisymmetricIndenter& body) {
    const double rim = body.outer_radius();
    std::optional<double> found;
    if (const auto d = c.load.indentation) {
        found = increasing_root([&](double a) { return body.plane_profile(a) - *d; }, *d, rim);
    } else {
        const double area = *c.load.normal_force / c.materials().effective_modulus();
        found = increasing_root([&](double a) { return body.pressed_area(a) - area; },
                                std::sqrt(area), rim);
    }
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

/// Scales of a cylinder of the length L on the half-space, long beside its contact, by Hertz:
///   a = line_half_width(), p0 = 2 F_N/(pi a L),
/// and by the displacement of the centre under pressure and traction that are uniform along L:
///   d = 2 F_N/(pi E* L) (1/2 + ln 2 + ln(L/a)),
///   U_max = mu 2 F_N/(pi E* L) lambda,  lambda = line_shift_factor() as below;
/// relative errors of (a/L)^2. The thesis' (3.5.2),
/// (3.5.3); its U_0 (3.5.12) has a fitted ln(1.8 E*/G*) instead of q: right for nu = 1/2 (0.993
/// beside 1), too much by 0.59 for nu = 0.
/// A prescribed d must be below that of a = L/10. Throws InputError.
HalfSpaceScales line_contact_scales(const Case& c) {
    const MaterialPair materials = c.materials();
    const double e_star = materials.effective_modulus();
    const Case::IndenterData& body = c.indenter;
    const double a = c.load.indentation
                         ? half_width_of_indentation(*c.load.indentation, body)
                         : line_half_width(*c.load.normal_force / body.length, body.radius, e_star);
    const double force =
        c.load.normal_force.value_or(pi * e_star * a * a / (4 * body.radius) * body.length);
    return {.contact_radius = a,
            .indentation = indentation_of(a, body),
            .normal_force = force,
            .peak_pressure = 2 * force / (pi * a * body.length),
            .unit_shift = friction_of(c) * a * a / (2 * body.radius) *
                          line_shift_factor(materials, body.length / a),
            .half_widths = {a, body.length / 2}};
}

/// Scales of a nominally flat contact, which Hertz' solution has not: the radius of a circle of the
/// nominal area; the rms height of the surface; p0 = E* h'/2, h' its rms slope, which is the rms
/// pressure of full contact (Johnson 1985, eq. 13.7) and about the mean one of light contact; F_N
/// as prescribed, or p0 on the nominal area where the indentation is.
HalfSpaceScales rough_scales(const Case& c) {
    const auto [height, slope] = spread(c.indenter);
    const double area = nominal_area(c), pressure = c.materials().effective_modulus() * slope / 2;
    const double radius = std::sqrt(area / std::numbers::pi);
    return {.contact_radius = radius,
            .indentation = height,
            .normal_force = c.load.normal_force.value_or(pressure * area),
            .peak_pressure = pressure,
            .unit_shift = shift_ratio(c) * height,
            .half_widths = {radius, radius}};
}

/// Pressures [Pa] on a radius of the contact, from the edge to the centre: r = a sqrt(1 - y^2) at
/// equal distances in y.
std::vector<double> radial_pressures(const Case& c, const HalfSpaceScales& s) {
    constexpr int pieces = 128;
    std::vector<double> values;
    const Case::Shape shape = c.indenter.shape;
    if (c.is_cylindrical() || shape == Case::Shape::ellipsoid || shape == Case::Shape::paraboloid ||
        shape == Case::Shape::sphere) {
        for (int k = 0; k <= pieces; ++k) values.push_back(s.peak_pressure * k / pieces);
        return values;
    }
    const auto body = c.make_axisymmetric_indenter();
    return RadialBound::of(pieces)->pressure_under(
        [&](double x) { return body->plane_profile(x); }, s.contact_radius,
        pi / 2 * body->profile_slope(0), c.materials().effective_modulus());
}

/// Of the traction tau(p) over p: the centre's displacement, and the force. On a circle, and an
/// ellipse, the former is an integral along the radius; of a line contact it is weighted with
/// -ln|x| + ln(L/a) + q, see line_contact_scales().
struct MeanFriction {
    double of_shift, of_force;
};
MeanFriction mean_friction(const Case& c, const HalfSpaceScales& s) {
    const auto law = c.friction.law();
    if (is_nominally_flat(c) || is_section_alone(c)) {
        const double ratio = law->ratio_at(s.peak_pressure);
        return {ratio, ratio};
    }
    const std::vector<double> pressure = radial_pressures(c, s),
                              bound = bounds_inside(*law, pressure);
    const int n = static_cast<int>(pressure.size()) - 1;
    const double beyond =
        c.is_cylindrical()
            ? line_shift_factor(c.materials(), c.indenter.length / s.contact_radius) -
                  centre_factor(1)
            : 0;
    // dr = a y/sqrt(1 - y^2) dy: midpoints in the angle asin y.
    const int points = 8 * n;
    double shift = 0, shift_of_pressure = 0, force = 0, force_of_pressure = 0;
    for (int i = 0; i < points; ++i) {
        const double angle = pi / 2 * (i + .5) / points;
        const auto at = [&](const std::vector<double>& values) {
            return at_depth_of_chord(values.data(), n, std::sin(angle));
        };
        const double radius = std::cos(angle);  // over a; dr = sin(angle) d(angle)
        const double weight = c.is_cylindrical() ? beyond - std::log(radius) : 1;
        const double area = c.is_cylindrical() ? 1 : radius;
        shift += std::sin(angle) * weight * at(bound);
        shift_of_pressure += std::sin(angle) * weight * at(pressure);
        force += std::sin(angle) * area * at(bound);
        force_of_pressure += std::sin(angle) * area * at(pressure);
    }
    return {shift / shift_of_pressure, force / force_of_pressure};
}

}  // namespace

HalfSpaceScales hertz_scales(const MaterialPair& materials, double radius, double normal_force,
                             double coulomb_coefficient) {
    const double e_star = materials.effective_modulus();
    const double d = std::pow(3 * normal_force / (4 * e_star * std::sqrt(radius)), 2. / 3);
    return hertz_scales_at(d, radius, materials, coulomb_coefficient);
}

double line_half_width(double load, double radius, double effective_modulus) {
    return std::sqrt(4 * load * radius / (pi * effective_modulus));
}

double line_shift_factor(const MaterialPair& materials, double length_ratio) {
    return centre_factor(length_ratio) + materials.nu_over_g() / materials.one_minus_nu_over_g();
}

double line_shift_factor(const Case& c) {
    return line_shift_factor(c.materials(),
                             c.indenter.length / half_space_scales(c).contact_radius);
}

bool is_nominally_flat(const Case& c) {
    return c.indenter.shape == Case::Shape::flat || c.indenter.shape == Case::Shape::height_map;
}

double nominal_area(const Case& c) {
    if (c.period) return *c.period * *c.period;
    const Vector2 side = c.indenter.height_map->period();
    return side[0] * side[1];
}

double expected_friction(const Case& c) {
    constexpr double mean_of_peak = 2. / 3;  // Hertz
    return c.friction.law()->ratio_at(mean_of_peak * half_space_scales(c).peak_pressure);
}

double cell_side(const Case& c) {
    const Cells& cells = c.of<Cells>();
    return cells.side(cells.spacing ? 0 : half_space_scales(c).contact_radius);
}

namespace {

HalfSpaceScales scales_of(const Case& c) {
    if (is_nominally_flat(c)) return rough_scales(c);
    if (is_section_alone(c)) return section_scales(c);
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

/// With the depth that a rig's drive leaves for the contact, d + F_N(d)/k_n = d_drive. F_N grows
/// with d: the root lies between 0 and d_drive.
Case behind_rig(const Case& c) {
    const double compliance = c.of<RigStiffness>().normal_compliance();
    if (!c.load.indentation || compliance == 0) return c;
    Case left = c;
    const double drive = *c.load.indentation;
    double low = 0, high = drive;
    while (high - low > 1e-12 * high) {
        const double middle = (low + high) / 2;
        left.load.indentation = middle;
        const double held = middle + compliance * scales_of(left).normal_force;
        (held < drive ? low : high) = middle;
        if (middle <= 1e-300) break;
    }
    left.load.indentation = high;
    return left;
}

}  // namespace

HalfSpaceScales half_space_scales(const Case& c) {
    HalfSpaceScales scales = scales_of(behind_rig(c));
    scales.friction_limit = friction_of(c) * scales.normal_force;
    if (c.friction.is_coulomb_at_rest()) return scales;
    const MeanFriction mean = mean_friction(c, scales);
    scales.unit_shift *= mean.of_shift;
    scales.friction_limit *= mean.of_force;
    return scales;
}

}  // namespace tricontact::contact
