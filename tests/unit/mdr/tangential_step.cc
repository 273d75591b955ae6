#include "mdr/tangential_step.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "contact/base/error.h"

namespace tricontact::tangential_step_test {
namespace {

TEST(MdrTangentialStep, OneSpringSticksAndSlides) {
    const std::vector<double> u{.2}, bound{.5};
    std::vector<double> after(1);
    const auto stick = mdr::take_step(u, bound, .1, 1e-12, after);
    EXPECT_DOUBLE_EQ(after[0], .3);
    EXPECT_EQ(stick.dissipated, 0);
    EXPECT_EQ(stick.n_stick, 1);
    const auto slide = mdr::take_step(u, bound, -1, 1e-12, after);
    EXPECT_EQ(after[0], -.5);
    EXPECT_DOUBLE_EQ(slide.dissipated, .5 * .3);  // of the way 1, .7 is taken by the spring
    EXPECT_EQ(slide.n_stick, 0);
}

TEST(MdrTangentialStep, FindsTheIncrementOfKnownZones) {
    // Two springs: bounds .1 and 1. Force 1 needs the first one to slide.
    const std::vector<double> u{0, 0}, bound{.1, 1};
    const auto found = mdr::find_increment(u, bound, 1., 2);
    EXPECT_NEAR(found.increment, .9, 1e-14);
    EXPECT_LE(found.iterations, 3);
}

// The second spring is met when three quarters of the step are over; its own way is what is left.
TEST(MdrTangentialStep, WhatIsMetOnTheWayIsCarriedByTheRest) {
    const std::vector<double> u{.1, 0}, bound{2, 2}, carried{1, .25};
    const auto found = mdr::find_increment(u, bound, carried, .6);
    EXPECT_NEAR(found.increment, .4, 1e-14);
    std::vector<double> after(2);
    const auto sums = mdr::take_step(u, bound, carried, found.increment, 1e-12, after);
    EXPECT_NEAR(after[1], .1, 1e-14);
    EXPECT_EQ(sums.n_stick, 2);
    // Work of the trapezoidal rule: on the springs, and what the second one was not there for.
    EXPECT_NEAR(sums.stored + sums.unmet, .4 * (.1 + .6) / 2, 1e-14);
    EXPECT_NEAR(sums.unmet, .1 * .3 / 2, 1e-14);
}

// Old deflections within bounds of their own, new bounds that may have shrunk below them.
struct Springs {
    std::vector<double> deflections, bounds;
    double total = 0, farthest = 0;
};

Springs random_springs() {
    Springs s;
    const int n = *rc::gen::inRange(1, 300);
    for (int i = 0; i < n; ++i) {
        s.bounds.push_back(*rc::gen::inRange(1, 1000) * 1e-3);
        s.deflections.push_back(*rc::gen::inRange(-1000, 1001) * 1e-3);
        s.total += s.bounds.back();
    }
    s.farthest = 2;
    return s;
}

RC_GTEST_PROP(MdrTangentialStep, ReachesEveryForceBelowTheLimit, ()) {
    const Springs s = random_springs();
    const double part = *rc::gen::element(-.9999999, -.999, -.3, 0., 1e-9, .5, .9, .999999);
    const double target = part * s.total;
    const auto found = mdr::find_increment(s.deflections, s.bounds, target, s.farthest);
    std::vector<double> after(s.bounds.size());
    const auto sums = mdr::take_step(s.deflections, s.bounds, found.increment, 0, after);
    RC_ASSERT(std::abs(sums.deflection - target) <= 1e-12 * s.total);
    RC_ASSERT(found.iterations < 60);
}

RC_GTEST_PROP(MdrTangentialStep, SlipOpposesTheLoadAndWorkIsKept, ()) {
    const Springs s = random_springs();
    const double increment = *rc::gen::inRange(-2000, 2001) * 1e-3;
    std::vector<double> after(s.bounds.size());
    const auto sums = mdr::take_step(s.deflections, s.bounds, increment, 0, after);
    double before = 0, slides_back = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const double slip = increment - (after[i] - s.deflections[i]);
        RC_ASSERT(std::abs(after[i]) <= s.bounds[i]);
        RC_ASSERT(after[i] * slip >= -1e-15);
        before += s.deflections[i];
        slides_back += std::abs(after[i] * slip);
    }
    RC_ASSERT(sums.bound_excess == 0);
    RC_ASSERT(sums.lowest_work == 0);
    RC_ASSERT(std::abs(sums.dissipated - slides_back) <= 1e-12 * (1 + slides_back));
    const double work = increment * (sums.deflection + before) / 2;
    RC_ASSERT(std::abs(work - sums.stored - sums.trapezoidal) <= 1e-12 * after.size());
}

TEST(MdrTangentialStep, SaysWhenThereIsNoSuchForce) {
    const std::vector<double> u{0, 0}, bound{.1, 1};
    try {
        mdr::find_increment(u, bound, 1.2, 2);
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("residual 0.0909 of the friction limit, 2 springs in contact"),
                  std::string::npos)
            << text;
    }
}

}  // namespace
}  // namespace tricontact::tangential_step_test
