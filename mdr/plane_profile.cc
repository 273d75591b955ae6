#include "mdr/plane_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contact/bodies/power_law.h"
#include "contact/error.h"
#include "contact/solvers/increasing_root.h"
#include "contact/special_values.h"
#include "mdr/tabulated_profile.h"

namespace tricontact::mdr {

namespace {

// Half width a in (0, range] at which an increasing function of it vanishes.
template <typename Function>
double half_width_root(Function function, double range, double start) {
    if (const auto root = contact::increasing_root(function, start, range)) return *root;
    throw contact::InputError(fmt::format(
        "indenter: the contact reaches the rim of its profile at {:.6g} m; reduce the load or "
        "enlarge the indenter",
        range));
}

}  // namespace

double PlaneProfile::half_width(double depth) const {
    if (!(depth > 0)) throw std::domain_error("half_width: the depth must be positive");
    return half_width_root([&](double a) { return value(a) - depth; }, range(), depth);
}

double PlaneProfile::half_width_of_area(double area) const {
    if (!(area > 0)) throw std::domain_error("half_width_of_area: the area must be positive");
    auto excess = [&](double a) { return 2 * (a * value(a) - integral(a)) - area; };
    return half_width_root(excess, range(), std::sqrt(area));
}

PowerLawProfile::PowerLawProfile(double coefficient, double exponent)
    : factor_(coefficient * contact::power_law_factor(exponent)), exponent_(exponent) {
    if (!(coefficient > 0) || !std::isfinite(coefficient))
        throw std::domain_error("PowerLawProfile: the coefficient must be positive and finite");
}

double PowerLawProfile::value(double x) const {
    return exponent_ == 2 ? factor_ * x * x : factor_ * std::pow(std::abs(x), exponent_);
}

void PowerLawProfile::sample(double first, double spacing, std::span<double> heights) const {
    const int n = static_cast<int>(heights.size());
    double* const height = heights.data();
    if (exponent_ != 2) {
        for (int i = 0; i < n; ++i) height[i] = value(first + i * spacing);
        return;
    }
#pragma omp simd
    for (int i = 0; i < n; ++i) {
        const double x = first + i * spacing;
        height[i] = factor_ * x * x;
    }
}

double PowerLawProfile::range() const {
    return contact::infinity;
}

double PowerLawProfile::integral(double a) const {
    return a * value(a) / (exponent_ + 1);
}

double PowerLawProfile::centre_integral(double a) const {
    if (exponent_ <= 1) return contact::infinity;
    return exponent_ / (exponent_ - 1) * value(a) / a;
}

std::unique_ptr<PlaneProfile> make_plane_profile(const contact::AxisymmetricIndenter& indenter,
                                                 double range) {
    if (const auto* paraboloid = dynamic_cast<const contact::Paraboloid*>(&indenter))
        return std::make_unique<PowerLawProfile>(1 / (2 * paraboloid->radius()), 2);
    if (const auto* power = dynamic_cast<const contact::PowerLaw*>(&indenter))
        return std::make_unique<PowerLawProfile>(power->coefficient(), power->exponent());
    // A rim may be vertical, as a ball's: g is infinite there.
    const double rim = 0.999 * indenter.outer_radius();
    return std::make_unique<TabulatedProfile>(indenter, std::min(range, rim));
}

}  // namespace tricontact::mdr
