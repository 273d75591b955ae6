// Which rows of a force curve are evaluated.

#include "experiments/identification/adhesion/adhesive_rows.h"

#include <gtest/gtest.h>

namespace tricontact::experiments::adhesive_rows_test {
namespace {

using enum AdhesiveWay;
using Ways = std::vector<AdhesiveWay>;
using Rows = std::vector<std::size_t>;

// Apart, jumped in, pressed; pulled, beyond the largest tension, let go.
TEST(AdhesiveRows, EndAtTheJumps) {
    const std::vector<double> depths{-2, -1, 0, 1, 2, 1, 0, -1, -2, -3},
        forces{0, 0, -2, 1, 5, 1, -2, -3, -2.5, 0};
    const AdhesiveRows found = adhesive_rows(depths, forces, .01);
    EXPECT_TRUE(found.shows_jump);
    EXPECT_EQ(found.rows, (Rows{3, 4, 5, 6}));
    EXPECT_EQ(found.ways, (Ways{joined, joined, held, held}));
    EXPECT_EQ(found.n_onsets, 1);
}

// Rows of both branches, sorted by their depth.
TEST(AdhesiveRows, ShowThatTheyAreSorted) {
    const std::vector<double> depths{-3, -2, -2, -1, -1, 0, 0, 1},
        forces{0, 0, -2.5, 0, -3, 0, -2, 1};
    EXPECT_EQ(adhesive_rows(depths, forces, .01).n_onsets, 3);
}

// Noise is no tension, and then all rows count: apart before the first touch.
TEST(AdhesiveRows, AreAllWithoutTension) {
    const std::vector<double> depths{-1, 0, 1, 0, -1}, forces{.02, -.03, 1, .02, -.02};
    const AdhesiveRows found = adhesive_rows(depths, forces, .02);
    EXPECT_FALSE(found.shows_jump);
    EXPECT_EQ(found.rows.size(), 5U);
    EXPECT_EQ(found.ways, (Ways{approach, approach, approach, separation, separation}));
}

// An error that is not stated is told by neighbours: of second differences +-4 e of an alternating
// one, e 4/(.6745 sqrt(6)).
TEST(AdhesiveRows, TellTheirError) {
    std::vector<double> depths, forces;
    for (int i = 0; i < 40; ++i) {
        depths.push_back(i);
        forces.push_back(i % 2 ? 1 : -1);
    }
    forces[0] = -19;
    EXPECT_FALSE(adhesive_rows(depths, forces, 0).shows_jump);
    forces[0] = -20;
    EXPECT_TRUE(adhesive_rows(depths, forces, 0).shows_jump);
}

}  // namespace
}  // namespace tricontact::experiments::adhesive_rows_test
