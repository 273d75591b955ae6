#include "mdr/plane_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/bodies/shapes_of_revolution.h"

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

constexpr double narrowest_panel = 1e-12;  // of the range

}  // namespace

double PlaneProfile::tip_slope(double a) const {
    constexpr double near = 1e-9;
    return std::isfinite(centre_integral(a)) ? 0 : value(near * a) / (near * a);
}

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
    if (!contact::is_positive_and_finite(coefficient))
        throw std::domain_error("PowerLawProfile: the coefficient must be positive and finite");
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

TabulatedProfile::TabulatedProfile(const contact::AxisymmetricIndenter& indenter, double range)
    : range_(range), conical_(indenter.profile_slope(0) > 0) {
    if (!(range > 0 && range <= indenter.outer_radius()) || !std::isfinite(range))
        throw std::domain_error("TabulatedProfile: the range must lie in (0, outer radius]");
    largest_slope_ = indenter.slope_moment(range, 0);
    double begin = 0;
    for (const double kink : indenter.kinks()) {
        if (kink >= range) break;
        tabulate(indenter, begin, kink);
        begin = kink;
    }
    tabulate(indenter, begin, range);
    check_monotone();
}

// Clenshaw (1955)
double TabulatedProfile::Panel::mean_slope(double x) const {
    const double t = (2 * x - begin - end) / (end - begin);
    double b1 = 0, b2 = 0;
    for (int k = n_terms - 1; k > 0; --k) {
        const double b0 = 2 * t * b1 - b2 + coefficients[k];
        b2 = b1;
        b1 = b0;
    }
    return t * b1 - b2 + coefficients[0];
}

// Interpolation in the roots of T_n: Press et al., Numerical Recipes (2007), eq. 5.8.7.
TabulatedProfile::Panel TabulatedProfile::fit(const contact::AxisymmetricIndenter& indenter,
                                              double begin, double end) {
    Panel panel{begin, end, {}};
    for (int j = 0; j < n_terms; ++j) {
        const double angle = std::numbers::pi * (j + 0.5) / n_terms;
        const double x = begin + (end - begin) * (1 + std::cos(angle)) / 2;
        const double slope = indenter.slope_moment(x, 0);
        for (int k = 0; k < n_terms; ++k)
            panel.coefficients[k] += (k == 0 ? 1. : 2.) / n_terms * slope * std::cos(k * angle);
    }
    return panel;
}

void TabulatedProfile::tabulate(const contact::AxisymmetricIndenter& indenter, double begin,
                                double end) {
    const Panel panel = fit(indenter, begin, end);
    const auto& c = panel.coefficients;
    // Beyond a kink g has a square root: panels shrink towards it, down to a width that no spring
    // falls into.
    const double tail = std::max(std::abs(c[n_terms - 1]), std::abs(c[n_terms - 2]));
    // Where g itself vanishes, beside a flat part, only rounding is left of its relative accuracy.
    const double accepted = std::max(1e-12 * std::abs(c[0]), 1e-14 * largest_slope_);
    if (tail <= accepted || end - begin <= narrowest_panel * range_) {
        panels_.push_back(panel);
        return;
    }
    const double middle = std::midpoint(begin, end);
    tabulate(indenter, begin, middle);
    tabulate(indenter, middle, end);
}

void TabulatedProfile::check_monotone() const {
    double lower = 0;
    for (const Panel& panel : panels_)
        for (int k = 1; k <= n_terms; ++k) {
            const double x = panel.begin + (panel.end - panel.begin) * k / n_terms;
            const double height = x * panel.mean_slope(x);
            if (!(height >= lower * (1 - 1e-9)))
                throw contact::InputError(fmt::format(
                    "indenter: the transformed profile decreases near r = {:.6g} m, so that its "
                    "contact would not be a disc; use a profile that is convex there",
                    x));
            lower = height;
        }
}

const TabulatedProfile::Panel& TabulatedProfile::panel_at(double distance) const {
    const auto after =
        std::upper_bound(panels_.begin(), panels_.end(), distance,
                         [](double x, const Panel& panel) { return x < panel.begin; });
    return *std::prev(after);
}

double TabulatedProfile::value(double x) const {
    const double distance = std::abs(x);
    if (!(distance <= range_)) return contact::infinity;
    return distance * panel_at(distance).mean_slope(distance);
}

void TabulatedProfile::sample(double first, double spacing, std::span<double> heights) const {
    const int n = static_cast<int>(heights.size());
    auto distance = [=](int i) { return std::abs(first + i * spacing); };
    for (int i = 0; i < n;) {
        if (!(distance(i) <= range_)) {
            heights[i++] = contact::infinity;
            continue;
        }
        // Neighbours on one panel go through the vector unit together.
        const Panel& panel = panel_at(distance(i));
        int last = i + 1;
        while (last < n && distance(last) >= panel.begin && distance(last) < panel.end) ++last;
        double* const height = heights.data();
#pragma omp simd
        for (int k = i; k < last; ++k) height[k] = distance(k) * panel.mean_slope(distance(k));
        i = last;
    }
}

double TabulatedProfile::integral(double a) const {
    double sum = 0;
    for (const Panel& panel : panels_) {
        if (panel.begin >= a) break;
        auto height = [&](double x) { return x * panel.mean_slope(x); };
        // a polynomial of degree 16: 15 Gauss points are exact
        sum += boost::math::quadrature::gauss<double, 15>::integrate(height, panel.begin,
                                                                     std::min(a, panel.end));
    }
    return sum;
}

// By parts: g(a)/a + ∫_0^a g/x^2 dx = s(a) + ∫_0^a s/x dx with the mean slope s = g/x.
double TabulatedProfile::centre_integral(double a) const {
    if (conical_) return contact::infinity;
    double sum = value(a) / a;
    for (const Panel& panel : panels_) {
        if (panel.begin >= a) break;
        auto integrand = [&](double x) { return panel.mean_slope(x) / x; };
        sum += boost::math::quadrature::gauss<double, 30>::integrate(integrand, panel.begin,
                                                                     std::min(a, panel.end));
    }
    return sum;
}

}  // namespace tricontact::mdr
