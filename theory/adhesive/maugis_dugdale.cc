#include "theory/adhesive/maugis_dugdale.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/base/root.h"
#include "contact/base/special_values.h"

namespace tricontact::theory {

namespace {

void require_above_zero_of_maugis(double value, const char* what) {
    if (!(value > 0)) throw std::domain_error(what);
}

}  // namespace

MaugisUnits maugis_units(double radius, double work, double modulus) {
    const double k = 4. / 3 * modulus, a = std::cbrt(std::numbers::pi * work * radius * radius / k);
    return {.radius = a, .force = std::numbers::pi * work * radius, .indentation = a * a / radius};
}

// With t = sqrt(m^2 - 1), which is known to full precision near m = 1: m - 1 = t^2/(m + 1) and
//   lambda A^2/2 [t + (m^2 - 2) atan t] + 4/3 lambda^2 A [t atan t - (m - 1)] = 1.
MaugisContact maugis_contact(double lambda, double radius) {
    require_above_zero_of_maugis(lambda, "maugis_contact: lambda <= 0");
    require_above_zero_of_maugis(radius, "maugis_contact: radius <= 0");
    const double opening = lambda * radius * radius / 2, pull = 4 * lambda * lambda * radius / 3;
    const auto excess = [&](double t) {
        const double m = std::sqrt(1 + t * t), angle = std::atan(t);
        return opening * (t + (t * t - 1) * angle) + pull * (t * angle - t * t / (m + 1)) - 1;
    };
    const double t = *contact::increasing_root(excess, 1., contact::infinity);
    const double m = std::sqrt(1 + t * t);
    return {
        .radius = radius,
        .ring = m,
        .force = radius * radius * radius - lambda * radius * radius * (t + m * m * std::atan(t)),
        .indentation = radius * radius - 4. / 3 * lambda * radius * t};
}

double maugis_parameter(double radius, double work, double modulus, double peak_stress) {
    require_above_zero_of_maugis(radius, "maugis_parameter: R <= 0");
    require_above_zero_of_maugis(work, "maugis_parameter: w <= 0");
    require_above_zero_of_maugis(modulus, "maugis_parameter: E* <= 0");
    require_above_zero_of_maugis(peak_stress, "maugis_parameter: sigma_0 <= 0");
    const double k = 4. / 3 * modulus;
    return 2 * peak_stress * std::cbrt(radius / (std::numbers::pi * work * k * k));
}

MaugisContact maugis_pull_off(double lambda) {
    // Between the point contact of Derjaguin, Muller and Toporov and A = 1.65 of Johnson, Kendall
    // and Roberts at P = 0, below which all pull-off lies; d/dA of P vanishes at most once.
    constexpr double least = 1e-6, most = 2;
    const auto force = [&](double a) { return maugis_contact(lambda, a).force; };
    return maugis_contact(lambda,
                          boost::math::tools::brent_find_minima(force, least, most, 30).first);
}

namespace {

/// A >= that of pull-off at which one of the controls, which grow with A there, is `value`.
MaugisContact beyond_pull_off(double lambda, double MaugisContact::*control, double value) {
    const MaugisContact pulled = maugis_pull_off(lambda);
    if (value < pulled.*control) throw std::domain_error("maugis_contact: pulled off");
    const auto excess = [&](double a) { return maugis_contact(lambda, a).*control - value; };
    double high = 2 * pulled.radius + 1;
    while (excess(high) < 0) high *= 2;
    return maugis_contact(lambda, contact::bracketed_root(excess, pulled.radius, high));
}

}  // namespace

MaugisContact maugis_contact_under(double lambda, double force) {
    return beyond_pull_off(lambda, &MaugisContact::force, force);
}

MaugisContact maugis_contact_at(double lambda, double indentation) {
    return beyond_pull_off(lambda, &MaugisContact::indentation, indentation);
}

}  // namespace tricontact::theory
