#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "meshes/layer_grid.h"

namespace tricontact::meshes::grading_test {
namespace {

// Geometric series, in the textbook's form.
double length_of(double first, double ratio, int n) {
    return ratio == 1 ? n * first : first * (std::pow(ratio, n) - 1) / (ratio - 1);
}

std::vector<double> edges_of(const Grading& strip) {
    const std::vector<double> nodes = strip.nodes();
    std::vector<double> edges;
    for (std::size_t i = 1; i < nodes.size(); ++i) edges.push_back(nodes[i] - nodes[i - 1]);
    return edges;
}

TEST(MeshesGrading, DoublingStripIsExact) {
    const Grading strip = grade(15 * 0.3, 0.3, 2);  // 0.3 (1 + 2 + 4 + 8)
    EXPECT_EQ(strip.n, 4);
    // the length is a rounded product; bisection ends at the last bit
    EXPECT_NEAR(strip.ratio, 2, 1e-14);
    const std::vector<double> edges = edges_of(strip);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(edges[k] / (0.3 * std::pow(2, k)), 1, 1e-13);
    EXPECT_EQ(strip.nodes().back(), 15 * 0.3);
}

TEST(MeshesGrading, EqualElementsWithoutGrowth) {
    const Grading strip = grade(7 * 0.1, 0.1, 1);
    EXPECT_EQ(strip.n, 7);
    EXPECT_NEAR(strip.ratio, 1, 1e-9);  // 7 * 0.1 is not 0.7: lengths are equal within 1e-9
    EXPECT_EQ(grade(0.71, 0.1, 1).n, 8);
    EXPECT_EQ(grade(0.71, 0.1, 1).ratio, 1);  // not seven of 0.1 and a sliver
    // no cancellation near 1: a million elements hardly grow
    EXPECT_EQ(graded_count(1e6, 1, 1), 1e6);
    EXPECT_EQ(graded_count(1e6, 1, 1 + 1e-13), 1e6);
}

TEST(MeshesGrading, ShortStrips) {
    EXPECT_EQ(grade(0, 0.5, 1.8).n, 0);
    EXPECT_EQ(grade(0, 0.5, 1.8).nodes(), (std::vector<double>{0}));
    EXPECT_EQ(grade(0.2, 0.5, 1.8).nodes(), (std::vector<double>{0, 0.2}));
    EXPECT_EQ(grade(0.5, 0.5, 1.8).nodes(), (std::vector<double>{0, 0.5}));
    // a second edge of 0.05 would be a sliver
    EXPECT_EQ(grade(0.55, 0.5, 1.8).nodes(), (std::vector<double>{0, 0.55}));
    // nor may one element outgrow the ratio
    EXPECT_EQ(grade(0.7, 0.5, 1.2).nodes(), (std::vector<double>{0, 0.35, 0.7}));
    // above first (1 + 1/growth) both have room
    const Grading two = grade(0.79, 0.5, 1.8);
    EXPECT_EQ(two.n, 2);
    EXPECT_NEAR(two.nodes()[1], 0.5, 1e-15);
    EXPECT_NEAR(two.ratio, 0.58, 1e-14);
}

RC_GTEST_PROP(MeshesGrading, FewestElementsOfBoundedGrowth, ()) {
    const double first = *rc::gen::inRange(1, 1000) * 1e-5;
    const double growth = 1 + *rc::gen::inRange(0, 200) * 0.01;
    const double length = first * (1 + 1 / growth) * (1 + *rc::gen::inRange(1, 5000) * 0.01);
    const Grading strip = grade(length, first, growth);
    const std::vector<double> edges = edges_of(strip);
    RC_ASSERT(static_cast<int>(edges.size()) == strip.n);
    // Lengths are equal within 1e-9, and so is all that follows from them.
    if (strip.ratio == 1) {
        RC_ASSERT(edges.front() <= first * (1 + 2e-9));
        RC_ASSERT(edges.front() >= first * (1 - 2e-9) * (strip.n - 1) / strip.n);
    } else {
        RC_ASSERT(std::abs(edges.front() / first - 1) < 2e-9);
    }
    RC_ASSERT(strip.nodes().back() == length);
    for (std::size_t k = 1; k < edges.size(); ++k) {
        RC_ASSERT(edges[k] <= edges[k - 1] * growth * (1 + 1e-8));
        RC_ASSERT(edges[k] >= edges[k - 1] / growth * (1 - 1e-8));
    }
    // one element less would have to grow more
    RC_ASSERT(length_of(first, growth, strip.n - 1) < length);
}

}  // namespace
}  // namespace tricontact::meshes::grading_test
