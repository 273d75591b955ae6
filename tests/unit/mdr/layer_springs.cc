#include "mdr/layer_springs.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/ooura_fourier_integrals.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::layer_springs_test {
namespace {

using contact::Material;
using contact::TangentialField;
using mdr::LayerKernel;
using mdr::LayerSprings;
using theory::LayerBase;
using theory::LayerStack;

LayerStack layer(double nu, LayerBase base = LayerBase::bonded) {
    return {{{{5.2e6, nu}, 8e-3}}, base, {}};
}

std::string message(const std::function<void()>& action) {
    try {
        action();
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

// The same integral by double exponential quadratures, which know of no panels.
double cosine_integral(const std::function<double(double)>& deficit, double over_thickness) {
    if (over_thickness == 0)
        return boost::math::quadrature::exp_sinh<double>().integrate(deficit) / std::numbers::pi;
    return boost::math::quadrature::ooura_fourier_cos<double>()
               .integrate(deficit, over_thickness)
               .first /
           std::numbers::pi;
}

TEST(MdrLayerKernel, IsTheCosineTransformOfTheDeficit) {
    constexpr double h = 1e-3, b = 8e-3;
    for (const double nu : {0., .3, .5})
        for (const auto base : {LayerBase::bonded, LayerBase::frictionless}) {
            const LayerKernel kernel = mdr::layer_kernel(layer(nu, base), h, 200);
            EXPECT_EQ(kernel.tangential.empty(), base == LayerBase::frictionless);
            for (const int m : {0, 1, 5, 40, 160}) {
                SCOPED_TRACE(::testing::Message() << "nu " << nu << ", s/b " << m * h / b);
                auto normal = [&](double x) {
                    return theory::half_space_deficit(nu, base, x).normal;
                };
                auto tangential = [&](double x) {
                    const auto deficit = theory::half_space_deficit(nu, base, x);
                    return ((1 - nu) * deficit.along + deficit.across) / (2 - nu);
                };
                // of the order 1/b; the quadratures promise 1e-8 and do better
                EXPECT_NEAR(kernel.normal[m] * b, cosine_integral(normal, m * h / b), 1e-9);
                if (base == LayerBase::bonded) {
                    EXPECT_NEAR(kernel.tangential[m] * b, cosine_integral(tangential, m * h / b),
                                1e-9);
                }
            }
        }
}

TEST(MdrLayerKernel, StackOfEqualLayersIsOne) {
    const LayerKernel one = mdr::layer_kernel(layer(.4), 5e-4, 100);
    LayerStack cut = layer(.4);
    cut.sheets = {{cut.sheets[0].material, 3e-3}, {cut.sheets[0].material, 5e-3}};
    const LayerKernel two = mdr::layer_kernel(cut, 5e-4, 100);
    LayerStack deep = cut;
    deep.half_space = cut.sheets[0].material;
    const LayerKernel none = mdr::layer_kernel(deep, 5e-4, 100);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_NEAR(two.normal[i] / one.normal[0], one.normal[i] / one.normal[0], 1e-11);
        EXPECT_NEAR(two.tangential[i] / one.normal[0], one.tangential[i] / one.normal[0], 1e-11);
        EXPECT_NEAR(none.normal[i] / one.normal[0], 0, 1e-11);
        EXPECT_NEAR(none.tangential[i] / one.normal[0], 0, 1e-11);
    }
}

TEST(MdrLayerSprings, MatrixIsItsProducts) {
    const LayerSprings springs(layer(.45), Material{50e6, .3}, 12, 5e-4);
    const int n = 25;
    ASSERT_EQ(springs.points().size(), static_cast<std::size_t>(n));
    EXPECT_NEAR(springs.points().x.front(), -6e-3, 1e-18);
    const Eigen::Map<const Eigen::MatrixXd> a(springs.dense(), 3 * n, 3 * n);
    EXPECT_EQ(a, a.transpose());
    Eigen::VectorXd force = Eigen::VectorXd::LinSpaced(3 * n, -1, 2).array().square();
    TangentialField t(n), u(n);
    std::vector<double> p(n), u_z(n);
    for (int i = 0; i < n; ++i) {
        const double area = springs.points().area[i];
        t.x[i] = force[i] / area;
        t.y[i] = force[n + i] / area;
        p[i] = force[2 * n + i] / area;
    }
    springs.normal(p, u_z);
    springs.tangential(t, u);
    const Eigen::VectorXd expected = a * force;
    for (int i = 0; i < n; ++i) {
        EXPECT_NEAR(u.x[i] / expected[0], expected[i] / expected[0], 1e-12);
        EXPECT_EQ(u.y[i], 0);
        EXPECT_NEAR(u_z[i] / expected[2 * n], expected[2 * n + i] / expected[2 * n], 1e-12);
    }
    // Traction on one element displaces it by this much.
    EXPECT_NEAR(springs.local_tangential() / (a(3, 3) * springs.points().area[3]), 1, 1e-14);
}

TEST(MdrLayerSprings, PositiveDefiniteFromThinToThick) {
    for (const double nu : {-.5, .3, .5})
        for (const double spacing : {2e-3, 2e-4, 1e-5}) {  // a quarter of the layer to a thousandth
            const int n = 121;
            const LayerSprings springs(layer(nu), {}, 60, spacing);
            const Eigen::Map<const Eigen::MatrixXd> a(springs.dense(), 3 * n, 3 * n);
            for (const int block : {0, 2}) {
                const Eigen::LLT<Eigen::MatrixXd> factor(a.block(block * n, block * n, n, n));
                EXPECT_EQ(factor.info(), Eigen::Success) << nu << " " << spacing << " " << block;
            }
        }
}

// 1/E* and 1/G* of both bodies, of which the layer takes back its own share only.
TEST(MdrLayerSprings, ElasticIndenterHasSpringsOfItsOwn) {
    const Material indenter{20e6, .2};
    const LayerSprings rigid(layer(.5), {}, 30, 2e-4), both(layer(.5), indenter, 30, 2e-4);
    const contact::MaterialPair pair({}, indenter);
    const int n = 61;
    const Eigen::Map<const Eigen::MatrixXd> a(rigid.dense(), 3 * n, 3 * n),
        b(both.dense(), 3 * n, 3 * n);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    expected.diagonal().head(n).setConstant(1 / pair.effective_shear_modulus() / 2e-4);
    expected.diagonal().tail(n).setConstant(1 / pair.effective_modulus() / 2e-4);
    EXPECT_LT((b - a - expected).cwiseAbs().maxCoeff(), 1e-13 * b.maxCoeff());
}

TEST(MdrLayerSprings, RefusesWhatItCannotDo) {
    EXPECT_EQ(message([] { LayerSprings springs(layer(.5), {}, 10, 2.1e-3); }),
              "mdr-layer: elements of 0.0021 m do not resolve a layer of 0.008 m; they must be "
              "shorter than 0.25 of it");
    EXPECT_THROW(LayerSprings(layer(.6), {}, 10, 1e-3), contact::InputError);
    const LayerSprings gliding(layer(.5, LayerBase::frictionless), {}, 10, 1e-3);
    TangentialField t(21), u(21);
    EXPECT_EQ(message([&] { gliding.tangential(t, u); }),
              "mdr-layer: nothing holds a layer on a frictionless base against a tangential force; "
              "take base = \"bonded\" or another model");
}

// A thin incompressible layer keeps its volume: it touches a paraboloid twice as far out as springs
// do, a = 2 sqrt(R d) but for the layer's own thickness. Gaps are left of terms (a/b)^2 times as
// large, to what rounding makes of those.
TEST(MdrLayerSprings, ContactSpreadsOnAThinIncompressibleLayer) {
    constexpr double b = 1e-3, radius = 1, reach = 80 * b, depth = reach * reach / radius;
    const LayerStack stack{{{{5.2e6, .5}, b}}, LayerBase::bonded, {}};
    const LayerSprings springs(stack, {}, 740, b / 4);
    std::vector<double> height;
    for (const double x : springs.points().x) height.push_back(x * x / radius);
    const auto s = contact::NormalSolver(springs, 1e-10)
                       .solve(height, {contact::NormalControl::Kind::indentation, depth});
    EXPECT_LE(s.residual, std::max(1e-10, s.rounding));
    EXPECT_LT(s.rounding, 1e-8);
    const auto touching = std::ranges::count_if(s.pressure, [](double p) { return p > 0; });
    EXPECT_NEAR(static_cast<double>(touching) * b / 8, 2 * reach, 2 * b);
}

}  // namespace
}  // namespace tricontact::layer_springs_test
