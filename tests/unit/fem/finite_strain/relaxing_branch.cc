#include "fem/finite_strain/relaxing_branch.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <random>

namespace tricontact::relaxing_branch_test {
namespace {

using fem::Dual;
using fem::MooneyRivlin;
using fem::Symmetric3;

constexpr double infinite = std::numeric_limits<double>::infinity();

// Integrals of the branch's strain itself, adaptively.
TEST(StepQuadrature, IntegratesWhatIsQuadraticInTheStrain) {
    using Adaptive = boost::math::quadrature::gauss_kronrod<double, 31>;
    for (const double x : {1e-9, 1e-4, .01, .0999, .1001, 1., 7., 100.}) {
        const fem::StepQuadrature quadrature(x);
        const double e = .7, w = -1.3;
        const auto strain = [&](double s) {
            const double once = s * x == 0 ? 1 : -std::expm1(-s * x) / (s * x);
            return e * std::exp(-s * x) + w * once * s;
        };
        const auto adaptive = [&](auto&& function) {
            return Adaptive::integrate(function, 0., 1., 15, 1e-14);
        };
        const auto sum = [&](auto&& function) {
            const auto& mean = quadrature.mean;
            return mean[0] * function(0.) + mean[1] * function(quadrature.middle) +
                   mean[2] * function(1.);
        };
        const auto square = [&](double s) { return strain(s) * strain(s); };
        // StepIntegrals are right to rounding of 1, and x ww or ww/x of them is taken.
        EXPECT_NEAR(sum(strain), adaptive(strain), 2e-13) << x;
        EXPECT_NEAR(sum(square), adaptive(square), 2e-13) << x;
        for (const double weight : quadrature.mean) EXPECT_GE(weight, -1e-15 * x);
        const contact::StepIntegrals s(x);
        EXPECT_NEAR(x * sum(square), e * e * s.ee + 2 * e * w * s.ew + w * w * s.ww,
                    1e-13 * (1 + x));
    }
}

// Nothing relaxes in no time, all in infinite time; weights are those of a mean in between.
TEST(ViscousShares, AreThoseOfAMean) {
    for (const double x : {0., 1e-9, .01, 1., 50., 1e9, infinite})
        for (const double rate : {1., 1.3, 20.}) {
            const fem::ViscousShares shares(x, rate);
            EXPECT_NEAR(shares.viscous + shares.start + shares.end, 1, 1e-15);
            for (const double share : {shares.viscous, shares.start, shares.end})
                EXPECT_GE(share, -1e-16);
        }
    EXPECT_EQ(fem::ViscousShares(0, 1.3).viscous, 1);
    EXPECT_EQ(fem::ViscousShares(0, 1.3).end, 0);
    EXPECT_EQ(fem::ViscousShares(infinite, 1.3).end, 1);
}

Symmetric3<double> random_strain(std::mt19937& generator, double size) {
    std::uniform_real_distribution<double> uniform(-size, size);
    Symmetric3<double> e;
    for (double& component : e) component = uniform(generator);
    return e;
}

// For a fixed viscous strain the power of T on dE_bar is the change of the energy: int tr(T C^-1
// dE).
TEST(RelaxingBranch, StressIsTheDerivativeOfTheEnergy) {
    std::mt19937 generator(3);
    for (int trial = 0; trial < 200; ++trial) {
        const double size = trial % 2 == 0 ? .15 : 1e-6;
        const auto viscous = fem::unimodular(random_strain(generator, size));
        const auto e = random_strain(generator, size), de = random_strain(generator, 1);
        Symmetric3<Dual<double>> moving, fixed;
        for (int k = 0; k < 6; ++k) {
            moving[k] = {e[k], de[k]};
            fixed[k] = viscous[k];
        }
        const auto isochoric = fem::unimodular(moving);
        const double change =
            branch_energy(MooneyRivlin<Dual<double>>{1.7, .6}, branch_strain(isochoric, fixed))
                .change;
        Symmetric3<double> at, rate;
        for (int k = 0; k < 6; ++k) {
            at[k] = isochoric[k].value;
            rate[k] = isochoric[k].change;
        }
        const auto t =
            branch_stress(MooneyRivlin<double>{1.7, .6}, fem::branch_strain(at, viscous));
        const auto strained = fem::product(rate, fem::cofactor(at));
        double size_of_terms = 0;
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) size_of_terms += std::abs(t[a][b] * strained[b][a]);
        EXPECT_NEAR((fem::trace_of_product(t, strained) - change) / size_of_terms, 0, 1e-13);
    }
}

}  // namespace
}  // namespace tricontact::relaxing_branch_test
