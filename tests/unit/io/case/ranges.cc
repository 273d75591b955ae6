// How the values of a study's range lie.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "io/case/study_reader.h"

namespace tricontact::io::ranges_test {
namespace {

using Scale = Study::Scale;
constexpr Scale all_scales[] = {Scale::linear, Scale::log, Scale::cosine, Scale::root_from,
                                Scale::root_to};

TEST(StudyRange, FractionIsTheInverse) {
    for (const Scale scale : all_scales) {
        const Study::Range range{.from = 0.3, .to = 40, .scale = scale, .points = {}};
        EXPECT_NEAR(range.value_at(0), 0.3, 1e-13);
        EXPECT_NEAR(range.value_at(1), 40, 1e-13);
        double before = 0;
        for (const double s : {0., .1, .35, .5, .8, 1.}) {
            const double value = range.value_at(s);
            EXPECT_GT(value, before);
            before = value;
            // The inverse of a root near its end loses half of the digits.
            EXPECT_NEAR(range.fraction_of(value), s, 1e-8);
        }
    }
}

TEST(StudyRange, CosineOfAQuarterTurnIsLinearInTheCosineOfTwiceTheAngle) {
    const Study::Range range{
        .from = 0, .to = std::numbers::pi / 2, .scale = Scale::cosine, .points = {}};
    for (const double s : {0., .2, .5, .9, 1.})
        EXPECT_NEAR(std::cos(2 * range.value_at(s)), 1 - 2 * s, 1e-14);
}

TEST(StudyRange, RootsAreThoseOfTheDistanceFromAnEnd) {
    const Study::Range low{.from = 1, .to = 5, .scale = Scale::root_from, .points = {}};
    EXPECT_DOUBLE_EQ(low.value_at(.5), 2);
    const Study::Range high{.from = 1, .to = 5, .scale = Scale::root_to, .points = {}};
    EXPECT_DOUBLE_EQ(high.value_at(.5), 4);
    const Study::Range ratios{.from = 1, .to = 16, .scale = Scale::log, .points = {}};
    EXPECT_DOUBLE_EQ(ratios.value_at(.5), 4);
}

}  // namespace
}  // namespace tricontact::io::ranges_test
