// Limits of shakedown by bisection: against the closed form of Hertz' contact, 1 - 3/2 w + 1/2 w^3,
// exact without coupling at any angle, and against the limit of the exact layer.

#include "comparisons/shakedown/limit_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/cells.h"
#include "tests/verification/bem/rig.h"
#include "tests/verification/mdr/roller.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::limit_search_test {
namespace {

using comparisons::LimitQuestion;
using comparisons::LimitVariable;
using comparisons::ModelLimit;

ModelLimit search(const contact::Case& c, const std::string& model, LimitQuestion question = {}) {
    const bool springs = model == "mdr";
    return comparisons::search_limit(
        c, model,
        [springs](const contact::Case& at) {
            return springs ? mdr::make_model(at) : bem::make_model(at, 1);
        },
        question, [](const std::string&) {});
}

void expect_bracketed(const ModelLimit& found, double exact, double resolution) {
    EXPECT_LE(found.bracket.last_shakedown, exact + resolution);
    EXPECT_GE(found.bracket.first_ratcheting, exact - resolution);
}

TEST(LimitSearch, MdrToOneMillionth) {
    for (const double w : {.24, .51, .8}) {
        const auto found = search(mdr_test::sphere_rig(w, .3, 10000, 6), "mdr");
        const double exact = theory::shakedown_limit(w);
        EXPECT_NEAR(found.bracket.centre(), exact, 1e-6) << w;
        expect_bracketed(found, exact, 1e-7);  // kinks between springs: dx^2/4 at dx = 2e-4 a
        EXPECT_NEAR(found.by_pressures, exact, 1e-7) << w;
        EXPECT_DOUBLE_EQ(found.exact.value(), exact);
        const auto shift = found.shift_ratio().value();
        EXPECT_LE(shift.low, 1 - w * w);
        EXPECT_GE(shift.high, 1 - w * w);
        EXPECT_NEAR(shift.value, 1 - w * w, 5e-4) << w;  // of the order of tolerance^(1/2)
    }
}

TEST(LimitSearch, MdrInTheAmplitude) {
    LimitQuestion question;
    question.variable = LimitVariable::amplitude;
    for (const double f : {.2, .56}) {
        const auto found = search(mdr_test::sphere_rig(.3, f, 10000, 6), "mdr", question);
        EXPECT_NEAR(found.bracket.centre(), theory::amplitude_limit(f), 1e-6) << f;
        EXPECT_NEAR(found.by_pressures, theory::amplitude_limit(f), 3e-7) << f;
    }
}

struct Direction {
    double w, angle;
};
class BemLimitSearch : public ::testing::TestWithParam<Direction> {};

TEST_P(BemLimitSearch, ToOneThousandth) {
    contact::Case c = bem::rig_case(GetParam().w, .3, 10);
    c.rolling->angle = GetParam().angle * std::numbers::pi / 180;
    const auto found = search(c, "bem");
    EXPECT_NEAR(found.bracket.centre(), theory::shakedown_limit(GetParam().w), 1e-3);
    // The discrete contact has its own exact limit: what the least pressures of its cells carry.
    expect_bracketed(found, found.by_pressures, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Directions, BemLimitSearch,
                         ::testing::Values(Direction{.24, 90}, Direction{.51, 0},
                                           Direction{.51, 30}));

TEST(LimitSearch, BemInTheAmplitude) {
    contact::Case c = bem::rig_case(.3, .3013255, 10);
    c.of<contact::Cells>().spacing = 4e-4;  // a bed of its own for each amplitude
    LimitQuestion question;
    question.variable = LimitVariable::amplitude;
    question.tolerance = 4e-3;
    const auto found = search(c, "bem", question);
    EXPECT_NEAR(found.bracket.centre(), .51, 4e-3);
}

}  // namespace
}  // namespace tricontact::limit_search_test
