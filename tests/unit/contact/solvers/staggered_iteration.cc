#include "contact/solvers/staggered_iteration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "contact/base/error.h"

namespace tricontact::staggered_iteration_test {
namespace {

using contact::StaggeredIterate;

constexpr double tolerance = 1e-9;

/// What friction does to the gap where all slides: errors turn into each other by +-i m, m = mu
/// beta (FixedPoint::max_iterations): h = 1 + i m h of a complex height h.
struct SlidingContact {
    double m;
    std::vector<double> last_height = {};
    double last_looseness = 0;

    StaggeredIterate operator()(const std::vector<double>& h, double looseness) {
        last_height = h;
        last_looseness = looseness;
        // Tangential contact is exact to its tolerance times the looseness.
        const double error = .1 * tolerance * looseness;
        StaggeredIterate now{{1 - m * h[1] + error, m * h[0] - error}, 0};
        for (int i = 0; i < 2; ++i)
            now.residual = std::max(now.residual, std::abs(now.height[i] - h[i]));
        return now;
    }
};

// h = 1 / (1 - i m) = (1 + i m) / (1 + m^2). Without acceleration m = 3 triples each error; four
// iterations, of m = .5, leave m^4 = 6 % of it. An error of h is at most that of g(h) - h over
// |1 - i m|: the tolerance, and as much for the inexact contact.
TEST(StaggeredIteration, EndsAtTheFixedPointOrThrows) {
    for (const double m : {.1, .5, 3.}) {
        SlidingContact contact{m};
        contact::stagger({"test", "", tolerance}, {0, 0},
                         [&](const auto& h, double looseness) { return contact(h, looseness); });
        EXPECT_NEAR(contact.last_height[0], 1 / (1 + m * m), 2 * tolerance) << m;
        EXPECT_NEAR(contact.last_height[1], m / (1 + m * m), 2 * tolerance) << m;
        EXPECT_EQ(contact.last_looseness, 1) << m;
    }
}

TEST(StaggeredIteration, NoAgreementIsAnError) {
    try {
        contact::stagger({"fem", " at phase 0.25", tolerance}, {0},
                         [](const std::vector<double>& h, double) {
                             return StaggeredIterate{{h[0] + 1}, 1};  // has no fixed point
                         });
        FAIL() << "ended without agreement";
    } catch (const contact::NotConverged& e) {
        EXPECT_NE(std::string(e.what()).find("fem: normal and tangential contact do not agree at "
                                             "phase 0.25: the gap still changes by 1.00e+00"),
                  std::string::npos)
            << e.what();
    }
}

// An indenter that is lifted: what friction had done before is gone at once, and no mean of both.
TEST(StaggeredIteration, WhereNothingTouchesTheHeightIsTakenAsItIs) {
    std::vector<double> heights;
    contact::stagger({"test", "", tolerance}, {3},
                     [&](const std::vector<double>& h, double looseness) {
                         heights.push_back(h[0]);
                         EXPECT_GE(looseness, 1);
                         return StaggeredIterate{{5}, std::abs(5 - h[0]), false};
                     });
    EXPECT_EQ(heights.front(), 3);
    for (std::size_t i = 1; i < heights.size(); ++i) EXPECT_EQ(heights[i], 5);
}

}  // namespace
}  // namespace tricontact::staggered_iteration_test
