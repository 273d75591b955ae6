#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contact/base/special_values.h"
#include "contact/relaxing_case.h"

namespace tricontact::stieltjes_interpolation_test {
namespace {

using contact::StieltjesInterpolation;

/// The largest relative error for C(x) = 1/(x + l), over x in [1, range] and l in [0, infinity].
double worst_error(const StieltjesInterpolation& interpolation, double range) {
    double worst = 0;
    for (int i = 0; i <= 100; ++i) {
        const double x = std::pow(range, i / 100.);
        const auto shares = interpolation.shares(x);
        auto error = [&](auto&& c) {
            double sum = 0;
            for (std::size_t j = 0; j < shares.size(); ++j)
                sum += shares[j] * c(interpolation.nodes[j]);
            return std::abs(sum / c(x) - 1);
        };
        worst = std::max(worst, error([](double) { return 1; }));  // l infinite
        worst = std::max(worst, error([](double y) { return 1 / y; }));
        for (int k = -60; k <= 60; ++k)
            worst = std::max(worst,
                             error([l = std::pow(10, k / 10.)](double y) { return 1 / (y + l); }));
    }
    return worst;
}

TEST(StieltjesInterpolation, ErrorIsBoundedWhateverTheBody) {
    for (const double range : {1.001, 1.3, 2.7, 30., 1e4})
        for (const double error : {1e-2, 1e-4, 1e-8}) {
            const StieltjesInterpolation interpolation(range, error);
            EXPECT_LE(interpolation.error, error);
            EXPECT_GE(interpolation.range, range);
            const double worst = worst_error(interpolation, interpolation.range);
            // The bound is met by some body; beyond it there is rounding alone, of weights 1e6.
            EXPECT_LT(worst, 1.001 * interpolation.error + 1e-8) << range << ' ' << error;
            if (error > 1e-8) {
                EXPECT_GT(worst, .5 * interpolation.error) << range << ' ' << error;
            }
            for (const double x : interpolation.nodes) EXPECT_GT(x, 1);
            for (const double a : interpolation.poles) EXPECT_GT(a, 0);
        }
}

// Few points, and as many more for each further digit.
TEST(StieltjesInterpolation, ConvergesExponentially) {
    EXPECT_EQ(StieltjesInterpolation(2, 1e-8).size(), 7u);
    EXPECT_EQ(StieltjesInterpolation(1e4, 1e-8).size(), 25u);
    auto size = [](double error) {
        return static_cast<double>(StieltjesInterpolation(30, error).size());
    };
    EXPECT_NEAR(size(1e-12) - size(1e-8), size(1e-8) - size(1e-4), 1);
}

// However small or large the range, weights of either sign stay small against what they add up to.
TEST(StieltjesInterpolation, WeightsAreSmall) {
    for (double excess = 1e-12; excess < 1e6; excess *= 3) {
        const StieltjesInterpolation interpolation(1 + excess, 1e-8);
        EXPECT_LT(interpolation.amplification(), 1e6) << excess;
    }
}

// A half-space pressed by an elastic body, whose Green's functions are these three. 1e-11: rounding
// of differences of C, which near nu = 1/2 differ little by pole.
TEST(StieltjesInterpolation, HalfSpaceIsExactByItsPoles) {
    using Bulk = contact::Relaxation::Bulk;
    contact::Case c;
    c.indenter.material = contact::Material{2e7, .2};
    c.relaxation.emplace();
    c.relaxation->branches = {{.3, .1}, {.6, 1}};
    for (const Bulk bulk : {Bulk::elastic, Bulk::proportional})
        for (const double poisson : {-.6, 0., .3, .45, .499, .5}) {
            c.substrate = {5e6, poisson};
            c.relaxation->bulk = bulk;
            const StieltjesInterpolation interpolation = contact::interpolation_of(c);
            EXPECT_EQ(interpolation.size(), bulk == Bulk::elastic && poisson < .5 ? 3u : 2u);
            for (const double x : {1., 1.3, 1.9}) {
                const auto at = [&](double ratio) {
                    return contact::with_relaxing_ratio(c, ratio).materials();
                };
                const auto shares = interpolation.shares(x);
                for (auto green : {&contact::MaterialPair::one_minus_nu_over_g,
                                   &contact::MaterialPair::nu_over_g,
                                   &contact::MaterialPair::one_minus_two_nu_over_g}) {
                    double sum = 0;
                    for (std::size_t j = 0; j < shares.size(); ++j)
                        sum += shares[j] * (at(interpolation.nodes[j]).*green)();
                    EXPECT_NEAR(sum, (at(x).*green)(), 1e-11 * at(x).one_minus_nu_over_g())
                        << poisson << ' ' << x;
                }
            }
        }
}

// The Green's functions of a layer are not those of a half-space: by its thickness, or because a
// model says so, as fem does of a mesh from a file.
TEST(StieltjesInterpolation, LayersAreBodiesOfAnyPoles) {
    contact::Case layer;
    layer.substrate = {5e6, .3};
    layer.relaxation.emplace();
    layer.relaxation->branches = {{.5, .1}};
    EXPECT_GT(worst_error(contact::interpolation_of(layer), 1.5), 1e-3);
    contact::Case thick = layer;
    thick.layer.thickness = 8e-3;
    for (const StieltjesInterpolation& interpolation :
         {contact::interpolation_of(thick), contact::interpolation_of(layer, false)})
        // The bound and rounding, as above.
        EXPECT_LT(worst_error(interpolation, interpolation.range), 2e-8);
}

// Two bodies of a common relaxation, one of them beside a spring, and an elastic one.
TEST(StieltjesInterpolation, KnownPolesCreep) {
    const contact::Relaxation solid{{{1.5, .2}}, {}};
    const auto interpolation = contact::interpolation_of(solid, {0, .8, contact::infinity});
    const auto creep = interpolation.creep(solid);
    ASSERT_EQ(creep.size(), 3u);
    EXPECT_NEAR(creep[1].relaxed, interpolation.factor(1, 1), 1e-15);
    EXPECT_NEAR(creep[1].relaxed - creep[1].branches[0].compliance, interpolation.factor(1, 2.5),
                1e-15);
    EXPECT_EQ(creep[2].relaxed, 1);
    EXPECT_TRUE(creep[2].branches.empty());
}

// A pole so far off that its term hardly bends is as good as infinite.
TEST(StieltjesInterpolation, ClosePolesAreNoneThatAreKnown) {
    const contact::Relaxation solid{{{.9, .2}}, {}};
    EXPECT_EQ(contact::interpolation_of(solid, {0, 1e8}).size(), 2u);
    EXPECT_EQ(contact::interpolation_of(solid, {0, 1e8, contact::infinity}).size(),
              contact::interpolation_of(solid).size());
    EXPECT_EQ(contact::interpolation_of(solid, {0, 1e-8}).size(),
              contact::interpolation_of(solid).size());
}

TEST(StieltjesInterpolation, NeedsARange) {
    EXPECT_THROW(StieltjesInterpolation(1, 1e-7), std::logic_error);
    EXPECT_THROW(StieltjesInterpolation(2, 0), std::logic_error);
}

}  // namespace
}  // namespace tricontact::stieltjes_interpolation_test
