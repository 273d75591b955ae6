#include "contact/bodies/line_contact_scales.h"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>

#include "contact/error.h"

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
    const boost::math::tools::eps_tolerance<double> precision(std::numeric_limits<double>::digits -
                                                              2);
    std::uintmax_t evaluations = 200;  // about 10 are needed
    const auto [left, right] =
        boost::math::tools::toms748_solve(excess, low, largest, precision, evaluations);
    return std::midpoint(left, right);
}

}  // namespace

double line_half_width(double load, double radius, double effective_modulus) {
    return std::sqrt(4 * load * radius / (pi * effective_modulus));
}

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
            .unit_shift = c.friction_coefficient * a * a / (2 * body.radius) *
                          line_shift_factor(materials, body.length / a),
            .half_widths = {a, body.length / 2}};
}

double line_shift_factor(const MaterialPair& materials, double length_ratio) {
    return centre_factor(length_ratio) + materials.nu_over_g() / materials.one_minus_nu_over_g();
}

}  // namespace tricontact::contact
