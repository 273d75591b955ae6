#include "mdr/normal_bed.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "mdr/plane_profile.h"

namespace tricontact::normal_bed_test {
namespace {

using mdr::NormalBed;
using mdr::PowerLawProfile;
using mdr::Window;

NormalBed paraboloid_bed(int n, double half_length) {
    return {std::make_unique<PowerLawProfile>(0.5, 2), n, half_length};  // g = x^2
}

double penetration_sum(const NormalBed& bed) {
    double sum = 0;
    for (int i = 0; i < bed.size(); ++i) {
        const double g = bed.profile().value(bed.spring_position(i) - bed.position());
        sum += std::max(bed.depth() - g, 0.);
    }
    return sum;
}

TEST(MdrNormalBed, SpringsSitInTheMiddleOfTheirCells) {
    const NormalBed bed = paraboloid_bed(4, 2);
    EXPECT_EQ(bed.spacing(), 1);
    EXPECT_EQ(bed.spring_position(0), -1.5);
    EXPECT_EQ(bed.spring_position(3), 1.5);
}

TEST(MdrNormalBed, DepthConvergesToHertz) {
    // a = d = 1, sum dx = 4/3. The edge at the same place of its cell in each bed, the error of the
    // midpoint rule falls exactly as dx^2.
    auto error = [](int cells) {
        const double dx = 1 / (cells + .2);
        NormalBed bed = paraboloid_bed(2 * cells + 6, (cells + 3) * dx);
        bed.press_to_sum(0, 4. / 3 / dx);
        return std::abs(bed.depth() - 1);
    };
    EXPECT_NEAR(std::log2(error(100) / error(200)), 2, .02);
    EXPECT_NEAR(std::log2(error(201) / error(402)), 2, .02);
    EXPECT_LT(error(200), 1e-5);
}

TEST(MdrNormalBed, IntersectionsOfWindows) {
    EXPECT_EQ(intersection(Window{2, 9}, Window{4, 12}).first, 4);
    EXPECT_EQ(intersection(Window{2, 9}, Window{4, 12}).last, 9);
    EXPECT_EQ(intersection(Window{2, 4}, Window{5, 7}).size(), 0);
}

// Whatever was pressed before, force and depth belong together and the window is the contact.
RC_GTEST_PROP(MdrNormalBed, PressesExactly, ()) {
    const int n = *rc::gen::inRange(10, 400);
    NormalBed bed = paraboloid_bed(n, 2);
    const int n_steps = *rc::gen::inRange(1, 6);
    for (int step = 0; step < n_steps; ++step) {
        const double position = *rc::gen::inRange(-1000, 1001) * 1e-3;
        const double sum = *rc::gen::inRange(1, 2000) * 1e-3 * n;
        bed.press_to_sum(position, sum);
        RC_ASSERT(std::abs(penetration_sum(bed) / sum - 1) < 1e-12);
        for (int i = 0; i < bed.size(); ++i) {
            const double x = bed.spring_position(i) - position;
            const bool inside = i >= bed.contact().first && i < bed.contact().last;
            RC_ASSERT(inside == (x * x < bed.depth()));
        }
        const double depth = bed.depth();
        const Window contact = bed.contact();
        bed.press_to_depth(-position / 2, .3);
        bed.press_to_depth(position, depth);
        RC_ASSERT(bed.contact().first == contact.first);
        RC_ASSERT(bed.contact().last == contact.last);
    }
}

TEST(MdrNormalBed, GrowingKeepsSpringsInPlace) {
    NormalBed bed = paraboloid_bed(100, 1);
    bed.press_to_sum(.7, 10);
    EXPECT_TRUE(bed.touches_end());
    const double third = bed.spring_position(3);
    bed.grow(50);
    EXPECT_EQ(bed.size(), 200);
    EXPECT_NEAR(bed.spring_position(53), third, 1e-15);
    bed.press_to_sum(.7, 10);
    EXPECT_FALSE(bed.touches_end());
    EXPECT_NEAR(penetration_sum(bed), 10, 1e-12);
}

TEST(MdrNormalBed, StaysWithinTheRangeOfItsProfile) {
    // The table ends at 0.1; springs beyond never count, from whichever side the profile comes.
    NormalBed bed(std::make_unique<mdr::TabulatedProfile>(contact::Sphere(1), .1), 1000, .5);
    for (const double position : {0., .3, -.35}) {
        bed.press_to_sum(position, .1);
        EXPECT_NEAR(penetration_sum(bed) / .1, 1, 1e-12) << position;
    }
}

TEST(MdrNormalBed, RefusesAnEmptyBed) {
    EXPECT_THROW(paraboloid_bed(0, 1), std::domain_error);
    EXPECT_THROW(paraboloid_bed(10, 0), std::domain_error);
}

}  // namespace
}  // namespace tricontact::normal_bed_test
