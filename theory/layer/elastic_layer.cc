#include "theory/layer/elastic_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "contact/base/error.h"
#include "contact/base/root.h"
#include "contact/base/special_values.h"
#include "theory/arguments.h"
#include "theory/contact_search.h"
#include "theory/layer/layer_equation.h"

namespace tricontact::theory {

namespace {

using contact::NormalControl;

constexpr const char* kinks_remedy = "declare the kinks of the indenter's profile";

double effective_modulus(const ElasticLayer& layer) {
    return 2 * layer.material.shear_modulus() / (1 - layer.material.poisson);
}

void check(const NormalControl& control) {
    const bool force = control.kind == NormalControl::Kind::force;
    if (!(control.value > 0) || !std::isfinite(control.value))
        throw contact::InputError(fmt::format(
            "layer contact: the {} must be positive and finite, but is {:.6g} {}; without contact "
            "there is nothing to solve",
            force ? "force" : "indentation", control.value, force ? "N" : "m"));
}

// Line loads over E* for unit indentation and for the profile alone; their difference, weighted
// by d, is the contact.
struct Parts {
    LayerEquation equation;
    LayerEquation::Solution unit, profile;  // per metre of indentation [-], and of g [m]

    // q(a) = 0
    double indentation() const { return profile.edge / unit.edge; }
    double integral(double d) const { return d * unit.integral - profile.integral; }
};

using PlaneProfile = std::function<double(double)>;

Parts solve_parts(const ElasticLayer& layer, LineMesh mesh, const PlaneProfile& g) {
    LayerEquation equation(layer, std::move(mesh));
    const auto& positions = equation.mesh().positions();
    std::vector<double> heights(positions.size());
    std::transform(positions.begin(), positions.end(), heights.begin(), g);
    auto unit = equation.solve(std::vector<double>(positions.size(), 1.), 1.);
    auto profile = equation.solve(heights, g(equation.mesh().radius()));
    return {std::move(equation), std::move(unit), std::move(profile)};
}

LayerContact make_contact(const ElasticLayer& layer, const Parts& parts, double d) {
    const double modulus = effective_modulus(layer), radius = parts.equation.mesh().radius();
    std::vector<double> q(parts.unit.values.size());
    for (std::size_t i = 0; i < q.size(); ++i)
        q[i] = modulus * (d * parts.unit.values[i] - parts.profile.values[i]);
    const double largest = *std::max_element(q.begin(), q.end());
    if (!(*std::min_element(q.begin(), q.end()) > -1e-8 * largest))
        throw contact::InputError(fmt::format(
            "layer contact: the line load changes its sign within a = {:.6g} m, so that the "
            "contact is no disc; use a convex profile",
            radius));
    LayerContact c{.contact_radius = radius,
                   .indentation = d,
                   .normal_force = 2 * modulus * parts.integral(d),
                   .normal_stiffness = 2 * modulus * parts.unit.integral,
                   .centre_pressure = 0,
                   .unit_shift = {},
                   .line_load = LineLoad(parts.equation.mesh(), q)};
    c.centre_pressure = c.pressure(0);
    if (layer.base == LayerBase::bonded) c.unit_shift = parts.equation.centre_shift(q);
    return c;
}

std::array<double, 3> key_values(const LayerContact& c) {
    return {c.indentation, c.normal_force, c.normal_stiffness};
}

}  // namespace

LayerContact solve_layer_contact(const ElasticLayer& layer,
                                 const contact::AxisymmetricIndenter& indenter,
                                 const NormalControl& control) {
    check(layer);
    check(control);
    const double b = layer.thickness, rim = indenter.outer_radius();
    const auto kinks = indenter.kinks();
    auto parts_at = [&](double radius, int n) {
        return solve_parts(layer, LineMesh(radius, kinks, n),
                           [&](double x) { return indenter.plane_profile(x); });
    };
    auto excess = [&](double radius) {
        const Parts parts = parts_at(radius, points_for(radius / b));
        const double d = parts.indentation();
        const bool force = control.kind == NormalControl::Kind::force;
        return (force ? 2 * effective_modulus(layer) * parts.integral(d) : d) / control.value - 1;
    };
    const double largest = std::min(rim * (1 - 1e-6), largest_radius_over_thickness * b);
    const double radius = find_radius(excess, b, largest, b);
    if (std::isinf(radius) && rim <= largest_radius_over_thickness * b)
        throw contact::InputError(fmt::format(
            "layer contact: the contact reaches the rim of the indenter at {:.6g} m; reduce the "
            "load or enlarge the indenter",
            rim));
    if (std::isinf(radius))
        throw contact::InputError(
            fmt::format("layer contact: the contact radius exceeds {} thicknesses; use the "
                        "asymptotic theory of "
                        "thin layers",
                        largest_radius_over_thickness));
    auto solve = [&](int n) {
        const Parts parts = parts_at(radius, n);
        return make_contact(layer, parts, parts.indentation());
    };
    LayerContact result = converged(solve, points_for(radius / b), key_values, kinks_remedy);
    if (indenter.profile_slope(0) > 0) result.centre_pressure = contact::infinity;
    return result;
}

double shakedown_limit(const LayerContact& contact, double w) {
    check_unit_interval("shakedown on a layer", "w = W/a", w);
    const double a = contact.contact_radius;
    return 1 - contact.line_load.integral(w * a) / contact.line_load.integral(a);
}

double amplitude_limit(const LayerContact& contact, double f) {
    check_unit_interval("shakedown on a layer", "f = F_T/(mu F_N)", f);
    if (f == 0 || f == 1) return 1 - f;
    const auto excess = [&](double w) { return shakedown_limit(contact, w) - f; };
    return contact::bracketed_root(excess, 0., 1., 1 - f, -f, 50);
}

}  // namespace tricontact::theory
