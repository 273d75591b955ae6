#include "theory/layer/sticking_contact.h"

#include <fmt/format.h>
#include <gsl/gsl_sf_bessel.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/base/error.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/wave_numbers.h"

namespace tricontact::theory {

namespace {

using std::numbers::pi;

/// A traction whose Hankel transform of its order (0 and 2: t_0, t_2; 1: p_1) is j_n(k a). In
/// Fourier space it acts along the wave vector, across it and normally, with these factors.
struct Shape {
    unsigned n;
    double along, across, normal;
};

std::vector<Shape> shapes_of(StickTractions tractions, unsigned n_each) {
    std::vector<Shape> shapes;
    for (unsigned i = 0; i < n_each; ++i) shapes.push_back({2 * i, 1, 1, 0});
    if (tractions == StickTractions::radial) return shapes;
    for (unsigned i = 0; i < n_each; ++i) shapes.push_back({2 * i + 2, -1, 1, 0});
    if (tractions == StickTractions::in_plane) return shapes;
    for (unsigned i = 0; i < n_each; ++i) shapes.push_back({2 * i + 1, 0, 0, 1});
    return shapes;
}

/// ∫_0^inf j_p(x) j_q(x) dx; Watson, Theory of Bessel Functions, section 13.41.
double bessel_integral(unsigned p, unsigned q) {
    const double sum = p + q + 1.;
    if (p == q) return pi / 2 / sum;
    const int difference = static_cast<int>(p) - static_cast<int>(q);
    if (difference % 2 == 0) return 0;
    return (std::abs(difference) % 4 == 1 ? 1 : -1) / (std::abs(difference) * sum);
}

/// j_0(x), ..., j_n_max(x); those far beyond x as zero: below 1e-25, and GSL's recurrence
/// overflows.
std::vector<double> spherical_bessel(unsigned n_max, double x) {
    std::vector<double> j(n_max + 1, 0.);
    gsl_sf_bessel_jl_steed_array(static_cast<int>(std::min<double>(n_max, 40 + 2 * x)), x,
                                 j.data());
    return j;
}

/// Twice the energy of two shapes per pi ∫ k ... dk.
double energy(const Shape& f, const Shape& g, const LayerCompliance& c) {
    return c.along * f.along * g.along + c.across * f.across * g.across +
           c.normal * f.normal * g.normal + c.coupling * (f.along * g.normal + f.normal * g.along);
}

/// G a times the half-space's matrix of energies.
Eigen::MatrixXd half_space_energies(const LayerCompliance& half_space,
                                    const std::vector<Shape>& shapes) {
    const auto n = static_cast<Eigen::Index>(shapes.size());
    Eigen::MatrixXd a(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            a(i, j) = pi * bessel_integral(shapes[i].n, shapes[j].n) *
                      energy(shapes[i], shapes[j], half_space);
    return a;
}

/// The same of the layer: the half-space's in closed form plus the difference.
Eigen::MatrixXd energies(const ElasticLayer& layer, double radius,
                         const std::vector<Shape>& shapes) {
    const double nu = layer.material.poisson, ratio = radius / layer.thickness;
    const LayerCompliance half_space{1 - nu, 1 - nu, 1, (1 - 2 * nu) / 2};  // times G k
    const WaveNumbers waves(ratio);
    const auto n = static_cast<Eigen::Index>(shapes.size()), n_waves = waves.size();
    const unsigned highest =
        std::max_element(shapes.begin(), shapes.end(), [](const Shape& f, const Shape& g) {
            return f.n < g.n;
        })->n;
    // Tangential shapes are of even order, normal ones of odd: a product for each pair of orders.
    const Eigen::Index n_even = highest / 2 + 1, n_odd = (highest + 1) / 2;
    Eigen::MatrixXd even(n_even, n_waves), odd(n_odd, n_waves);
    Eigen::VectorXd by_along(n_waves), by_across(n_waves), by_normal(n_waves), by_both(n_waves);
    for (Eigen::Index w = 0; w < n_waves; ++w) {
        const double x = waves.points()[w], scale = layer.material.shear_modulus() * x;
        const LayerCompliance c = layer_compliance({layer.material, 1, layer.base}, x);
        const double weight = pi * ratio * waves.weights()[w];
        by_along[w] = weight * (c.along * scale - half_space.along);
        by_across[w] = weight * (c.across * scale - half_space.across);
        by_normal[w] = weight * (c.normal * scale - half_space.normal);
        by_both[w] = weight * (c.coupling * scale - half_space.coupling);
        const std::vector<double> j = spherical_bessel(highest, x * ratio);
        for (Eigen::Index i = 0; i < n_even; ++i) even(i, w) = j[2 * i];
        for (Eigen::Index i = 0; i < n_odd; ++i) odd(i, w) = j[2 * i + 1];
    }
    const Eigen::MatrixXd along = even * by_along.asDiagonal() * even.transpose(),
                          across = even * by_across.asDiagonal() * even.transpose();
    Eigen::MatrixXd normal, both;
    if (std::ranges::any_of(shapes, [](const Shape& f) { return f.normal != 0; })) {
        normal = odd * by_normal.asDiagonal() * odd.transpose();
        both = even * by_both.asDiagonal() * odd.transpose();
    }
    Eigen::MatrixXd a = half_space_energies(half_space, shapes);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index k = 0; k < n; ++k) {
            const Shape &f = shapes[i], &g = shapes[k];
            const auto p = static_cast<Eigen::Index>(f.n / 2),
                       q = static_cast<Eigen::Index>(g.n / 2);
            if (f.normal == 0 && g.normal == 0)
                a(i, k) += f.along * g.along * along(p, q) + f.across * g.across * across(p, q);
            else if (f.normal != 0 && g.normal != 0)
                a(i, k) += f.normal * g.normal * normal(p, q);
            else
                a(i, k) += f.normal == 0 ? f.along * g.normal * both(p, q)
                                         : g.along * f.normal * both(q, p);
        }
    return a;
}

// The force is 2 pi times the coefficient of j_0, the only one that is not zero at k = 0: least
// energy less U F_T gives F_T/U = (2 pi)^2 (A^-1)_00.
double stiffness_by(const ElasticLayer& layer, double radius, StickTractions tractions, int n) {
    const auto shapes = shapes_of(tractions, static_cast<unsigned>(n));
    const auto factor = energies(layer, radius, shapes).ldlt();
    const Eigen::VectorXd first =
        Eigen::VectorXd::Unit(static_cast<Eigen::Index>(shapes.size()), 0);
    return 4 * pi * pi * layer.material.shear_modulus() * radius * factor.solve(first)[0];
}

void check_radius(double radius, double largest) {
    if (radius > 0 && radius <= largest) return;
    throw contact::InputError(fmt::format(
        "sticking contact: the radius must be positive and at most {:.6g} m, but is {:.6g} m; "
        "correct it",
        largest, radius));
}

}  // namespace

double sticking_stiffness(const contact::MaterialPair& materials, double radius) {
    check_radius(radius, std::numeric_limits<double>::max());
    return 2 * materials.effective_shear_modulus() * radius;
}

double sticking_stiffness(const ElasticLayer& layer, double radius, StickTractions tractions) {
    check(layer);
    check_radius(radius, largest_radius_over_thickness * layer.thickness);
    if (layer.base == LayerBase::frictionless)
        throw contact::InputError(
            "sticking contact: nothing holds a layer on a frictionless base against a tangential "
            "force; take a bonded one");
    // 24 resolve a/b = 32 to 1e-10 if stresses do not oscillate at the edge. Else the energy's
    // error falls as 1/n^2.
    const int n = 24 + static_cast<int>(radius / layer.thickness / 4);
    const double coarse = stiffness_by(layer, radius, tractions, n);
    if (tractions != StickTractions::all) return coarse;
    return (4 * stiffness_by(layer, radius, tractions, 2 * n) - coarse) / 3;
}

}  // namespace tricontact::theory
