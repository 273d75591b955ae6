#include <gtest/gtest.h>

#include <cmath>

#include "atlas/fit_atlas.h"
#include "comparisons/quantities/quantities.h"

namespace tricontact::atlas::cut_domain_test {
namespace {

namespace quantities = comparisons::quantities;

Atlas plane() {
    Atlas atlas{.name = "plane"};
    for (const char* key : {"rolling.amplitude_ratio", "load.limit_fraction"})
        atlas.axes.emplace_back(
            key,
            io::Study::Range{.from = 0, .to = 1, .scale = io::Study::Scale::linear, .points = {}});
    atlas.maps.push_back({.quantity = &quantities::settled_shift_ratio});
    return atlas;
}

/// A settled shift where `settles` says so.
template <class F>
std::vector<Sample> samples_where(F settles) {
    std::vector<Sample> samples;
    for (int i = 0; i <= 20; ++i)
        for (int j = 0; j <= 20; ++j) {
            Sample sample{{.05 * i, .05 * j}, {}, {}, {}};
            if (settles(.05 * i, .05 * j)) sample.finest.set(quantities::settled_shift_ratio, .5);
            samples.push_back(sample);
        }
    return samples;
}

TEST(CutDomain, NothingIsCutWhereAllIsDefined) {
    Atlas atlas = plane();
    cut_domain(atlas, samples_where([](double, double) { return true; }));
    for (const Axis& axis : atlas.axes) {
        EXPECT_EQ(axis.from, 0);
        EXPECT_EQ(axis.to, 1);
    }
}

TEST(CutDomain, ACornerCostsOneEnd) {
    Atlas atlas = plane();
    // One row lies above y = 0.97, three columns beyond x = 0.88: 5 and 15 % of the square.
    cut_domain(atlas, samples_where([](double x, double y) { return x < .88 || y < .97; }));
    EXPECT_EQ(atlas.axes[0].to, 1);
    EXPECT_NEAR(atlas.axes[1].to, .95, 1e-12);
    EXPECT_EQ(atlas.axes[1].from, 0);
    EXPECT_FALSE(atlas.axes[1].is_inside(.97));
    EXPECT_TRUE(atlas.axes[1].is_inside(.95));
    // The coordinate that polynomials are about stays.
    EXPECT_EQ(atlas.axes[1].range.to, 1);
}

TEST(CutDomain, OfTwoCutsAlikeThatOfTheAmplitudeIsTaken) {
    Atlas atlas = plane();
    cut_domain(atlas, samples_where([](double x, double y) { return x < .88 || y < .88; }));
    EXPECT_NEAR(atlas.axes[0].to, .85, 1e-12);
    EXPECT_EQ(atlas.axes[1].to, 1);
}

TEST(CutDomain, AQuantityThatIsUndefinedInHalfTheDomainCutsNothing) {
    Atlas atlas = plane();
    cut_domain(atlas, samples_where([](double x, double y) { return x + y < 1; }));
    EXPECT_EQ(atlas.axes[0].to, 1);
    EXPECT_EQ(atlas.axes[1].to, 1);
}

}  // namespace
}  // namespace tricontact::atlas::cut_domain_test
