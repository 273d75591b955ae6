// The condensed layer under smooth tractions against the compliance of the infinite layer in
// Fourier space: energies, displacements, coupling, order of convergence.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

#include "fem/condensed_layer.h"
#include "fem/settings.h"
#include "tests/unit/fem/box_mesh.h"
#include "theory/layer/layer_compliance.h"

namespace tricontact::fem_condensation_test {
namespace {

using contact::Case;
using contact::Material;
using theory::ElasticLayer;
using theory::LayerBase;

constexpr double young = 5.2e6, thickness = 4e-3, width = 1.6e-3, patch = 6e-3;
constexpr double peak = 1e5;  // of the traction [Pa]; linear: any

// Traction exp(-r^2/width^2): 1e-6 of its peak at the patch's edge.
double traction(double x, double y) {
    return peak * std::exp(-(x * x + y * y) / (width * width));
}
double traction_hat(double k) {
    return peak * std::numbers::pi * width * width * std::exp(-k * k * width * width / 4);
}

// Integral over all wave vectors, divided by (2 pi)^2, of a function of their length.
template <typename F>
double integrate_waves(F f) {
    const double largest = 14 / width;  // traction_hat^2 falls to 1e-42
    const int n_panels = 60;
    double sum = 0;
    for (int i = 0; i < n_panels; ++i)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(
            [&](double k) { return k * f(k); }, largest * i / n_panels,
            largest * (i + 1) / n_panels);
    return sum / (2 * std::numbers::pi);
}

constexpr double radial_at = 2e-3;

struct Answers {
    double normal;      // twice the work of the traction as a pressure
    double tangential;  // and along x
    double centre;      // depression under the pressure
    double radial;      // displacement away from its centre, at radial_at
};

Answers exact_normal(const ElasticLayer& layer) {
    const auto integrate = [&](auto f) {
        return integrate_waves(
            [&](double k) { return f(theory::layer_compliance(layer, k), k, traction_hat(k)); });
    };
    using C = theory::LayerCompliance;
    return {integrate([](const C& c, double, double t) { return c.normal * t * t; }), 0,
            integrate([](const C& c, double, double t) { return c.normal * t; }),
            integrate([](const C& c, double k, double t) {
                return -c.coupling * t * boost::math::cyl_bessel_j(1, k * radial_at);
            })};
}
Answers exact_bonded(double poisson) {
    const ElasticLayer layer{{young, poisson}, thickness, LayerBase::bonded};
    auto answers = exact_normal(layer);
    answers.tangential = integrate_waves([&](double k) {
        const auto c = theory::layer_compliance(layer, k);
        return (c.along + c.across) / 2 * traction_hat(k) * traction_hat(k);
    });
    return answers;
}

std::vector<double> subdivided(const std::vector<double>& lines, int n) {
    std::vector<double> finer{lines[0]};
    for (std::size_t i = 1; i < lines.size(); ++i)
        for (int k = 1; k <= n; ++k)
            finer.push_back(lines[i - 1] + (lines[i] - lines[i - 1]) * k / n);
    return finer;
}

// Half model; every interval of a coarse mesh cut into n: its smallest elements are 2 mm / n.
test::BoxSpec coarse_spec(int n, double half_width = 27e-3) {
    std::vector<double> x{0, 2e-3, 4e-3, 6e-3, 9e-3, 15e-3, 27e-3};
    while (x.back() < half_width) x.push_back(std::min(half_width, 1.8 * x.back()));
    return {subdivided(test::mirrored(x), n),
            subdivided(x, n),
            subdivided({-thickness, -2e-3, 0}, n),
            patch,
            patch,
            true};
}
fem::LayerProblem coarse_layer(double poisson, int n, double half_width = 27e-3) {
    fem::LayerProblem problem;
    problem.mesh = test::box_mesh(coarse_spec(n, half_width));
    problem.materials = {Material{young, poisson}, Material{young, poisson}};
    return problem;
}

// Integrals of the traction times each shape function of the surface, of the modelled half [N].
std::vector<double> consistent_force(const contact::ContactPoints& points) {
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    const auto quadratic = [](int i, double s) {  // 1 at the corner 0, the corner 1, the middle
        return i == 0 ? (1 - s) * (1 - 2 * s) : i == 1 ? s * (2 * s - 1) : 4 * s * (1 - s);
    };
    constexpr int along[9] = {0, 1, 1, 0, 2, 1, 2, 0, 2}, across[9] = {0, 0, 1, 1, 0, 2, 1, 2, 2};
    std::vector<double> force(points.size(), 0.);
    for (const auto& quad : points.quads) {
        const double x0 = points.x[quad[0]], y0 = points.y[quad[0]];
        const double ux = points.x[quad[1]] - x0, uy = points.y[quad[1]] - y0;
        const double vx = points.x[quad[3]] - x0, vy = points.y[quad[3]] - y0;
        for (int i = 0; i < 9; ++i)
            force[quad[i]] +=
                (ux * vy - uy * vx) *
                Gauss::integrate(
                    [&](double s) {
                        return Gauss::integrate(
                            [&](double t) {
                                return quadratic(along[i], s) * quadratic(across[i], t) *
                                       traction(x0 + s * ux + t * vx, y0 + s * uy + t * vy);
                            },
                            0., 1.);
                    },
                    0., 1.);
    }
    return force;
}

// The same of a condensed layer.
Answers computed(const fem::CondensedLayer& layer) {
    const std::size_t n = layer.points.size();
    const auto force = consistent_force(layer.points);
    // Displacement in direction d of point i under the forces in direction e.
    const auto displacement = [&](int d, std::size_t i, int e) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k)
            sum += layer.compliance[(e * n + k) * 3 * n + d * n + i] * force[k];
        return sum;
    };
    Answers result{};
    for (std::size_t i = 0; i < n; ++i) {
        result.normal += 2 * force[i] * displacement(2, i, 2);  // both halves
        result.tangential += 2 * force[i] * displacement(0, i, 0);
        if (layer.points.y[i] != 0) continue;
        if (std::abs(layer.points.x[i]) < 1e-9) result.centre = displacement(2, i, 2);
        // Pressure acts along -z.
        if (std::abs(layer.points.x[i] - radial_at) < 1e-9) result.radial = -displacement(0, i, 2);
    }
    return result;
}

// Errors over the exact values; those of displacements over the depression.
Answers errors(const fem::LayerProblem& problem, const Answers& exact) {
    const Answers result = computed(fem::condense(problem));
    const double tangential = exact.tangential > 0 ? result.tangential / exact.tangential - 1 : 0;
    return {std::abs(result.normal / exact.normal - 1), std::abs(tangential),
            std::abs(result.centre - exact.centre) / exact.centre,
            std::abs(result.radial - exact.radial) / exact.centre};
}

class FemCondensationOfMaterial : public testing::TestWithParam<double> {};

TEST_P(FemCondensationOfMaterial, Converges) {
    const auto exact = exact_bonded(GetParam());
    std::vector<Answers> error;
    for (const int n : {1, 2, 3}) error.push_back(errors(coarse_layer(GetParam(), n), exact));
    const auto order = [&](double Answers::*what, int from, int to) {
        return std::log(error[from - 1].*what / (error[to - 1].*what)) /
               std::log(static_cast<double>(to) / from);
    };
    // Quadratic displacements: energies with h^4, from elements wider than the load (2 mm against
    // 1.6 mm) on, hence the margins.
    for (const auto what : {&Answers::normal, &Answers::tangential}) {
        EXPECT_GT(order(what, 1, 3), 3.6);
        EXPECT_GT(order(what, 2, 3), 2.8);
        EXPECT_LT(error[2].*what, 3e-4);
    }
    // Displacements: h^3 under the load, with the same margin, slower beside it.
    EXPECT_GT(order(&Answers::centre, 1, 3), 2.6);
    EXPECT_LT(error[2].centre, 1.2e-2);
    EXPECT_GT(order(&Answers::radial, 2, 3), 2);
    EXPECT_LT(error[2].radial, 6e-3);
}
INSTANTIATE_TEST_SUITE_P(, FemCondensationOfMaterial, testing::Values(-.3, .3, .49, .5));

// Fixed sides far away, for nothing else holds the layer: what it spreads decays like 1/r only.
TEST(FemCondensation, FrictionlessBase) {
    for (const double nu : {.3, .5}) {
        const auto exact = exact_normal({{young, nu}, thickness, LayerBase::frictionless});
        auto problem = coarse_layer(nu, 2, 200e-3);
        problem.base = Case::Base::frictionless;
        problem.sides = fem::Sides::fixed;
        const auto error = errors(problem, exact);
        EXPECT_LT(error.normal, 3e-3) << nu;  // of the bonded layer at the same size: 1.5e-3
        EXPECT_LT(error.centre, 5e-2) << nu;
        EXPECT_LT(error.radial, 2e-2) << nu;
    }
}

// Two layers of one material are one; on a stiff lower one the upper is bonded to a rigid base.
TEST(FemCondensation, LowerLayers) {
    auto problem = coarse_layer(.5, 2);
    const auto one = computed(fem::condense(problem));
    auto& mesh = problem.mesh;
    for (std::size_t h = 0; h < mesh.hexes.size(); ++h)
        if (mesh.nodes[mesh.hexes[h][6]][2] < -1.9e-3)  // a node of its upper face
            mesh.regions[h] = meshes::Region::lower_layer;
    const auto two = computed(fem::condense(problem));
    EXPECT_EQ(one.normal, two.normal);
    problem.materials[1].young *= 1e7;
    const auto on_stiff = computed(fem::condense(problem));

    auto thin = coarse_layer(.5, 2);
    test::BoxSpec spec = coarse_spec(2);
    spec.z = subdivided({-2e-3, 0}, 2);
    thin.mesh = test::box_mesh(spec);
    const auto on_rigid = computed(fem::condense(thin));
    EXPECT_LT(on_rigid.normal, .6 * one.normal);
    EXPECT_NEAR(on_stiff.normal / on_rigid.normal, 1, 1e-5);  // 1e-7 by the moduli
    EXPECT_NEAR(on_stiff.tangential / on_rigid.tangential, 1, 1e-5);
}

// 27 mm (nearly seven thicknesses) are wide enough.
TEST(FemCondensation, FarSidesDoNotMatter) {
    auto problem = coarse_layer(.5, 1);
    const auto free = computed(fem::condense(problem));
    problem.sides = fem::Sides::fixed;
    const auto fixed = computed(fem::condense(problem));
    EXPECT_NEAR(fixed.normal / free.normal, 1, 1e-4);
    EXPECT_NEAR(fixed.tangential / free.tangential, 1, 1e-4);
    EXPECT_NE(fixed.normal, free.normal);
}

}  // namespace
}  // namespace tricontact::fem_condensation_test
