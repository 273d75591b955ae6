#include "theory/adhesion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tricontact::theory {

namespace {

void require_above_zero(double value, const char* what) {
    if (!(value > 0)) throw std::domain_error(what);
}

}  // namespace

double pull_off_force(Adhesion theory, double radius, double work) {
    require_above_zero(radius, "pull_off_force: R <= 0");
    require_above_zero(work, "pull_off_force: w <= 0");
    return (theory == Adhesion::jkr ? 1.5 : 2) * std::numbers::pi * work * radius;
}

double adhesive_contact_radius(Adhesion theory, double force, double radius, double modulus,
                               double work) {
    require_above_zero(modulus, "adhesive_contact_radius: E* <= 0");
    if (!(force >= -pull_off_force(theory, radius, work)))
        throw std::domain_error("adhesive_contact_radius: pulled off");
    const double scale = 3 * radius / (4 * modulus);
    const double tension = std::numbers::pi * work * radius;
    if (theory == Adhesion::dmt) return std::cbrt(scale * (force + 2 * tension));
    // The root is zero at pull-off.
    const double root = std::sqrt(std::max(0., 6 * tension * force + 9 * tension * tension));
    return std::cbrt(scale * (force + 3 * tension + root));
}

double tabor_parameter(double radius, double work, double modulus, double distance) {
    require_above_zero(radius, "tabor_parameter: R <= 0");
    require_above_zero(work, "tabor_parameter: w <= 0");
    require_above_zero(modulus, "tabor_parameter: E* <= 0");
    require_above_zero(distance, "tabor_parameter: z0 <= 0");
    return std::cbrt(radius * std::pow(work / modulus, 2) / std::pow(distance, 3));
}

}  // namespace tricontact::theory
