// rolling.until = "settled": near the limit a run ends early, with the settled shift extrapolated.

#include <gtest/gtest.h>

#include <cmath>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "theory/rolling/body_rolling.h"

namespace tricontact::settled_run_test {
namespace {

using contact::Case;
using contact::History;
using contact::State;

constexpr double amplitude = .24,
                 limit = 1 - 1.5 * amplitude + .5 * amplitude * amplitude * amplitude;

Case near_limit(double distance, int periods) {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {3e6, .5};
    c.friction.coefficient = .5;
    c.load.normal_force = 20;
    c.load.tangential_ratio = limit * (1 - distance);
    c.rolling.emplace();
    c.rolling->amplitude_ratio = amplitude;
    c.rolling->steps = Case::Steps::turning_points;
    c.rolling->periods = periods;
    c.rolling->until = Case::Until::settled;
    c.of<contact::Cells>().per_radius = 8;
    return c;
}

double shift_ratio(const History& h) {
    return h.shift_per_period.back() / h.scales.unit_shift;
}

int periods(const History& h) {
    return static_cast<int>(h.shift_per_period.size());
}

TEST(SettledRun, OfMdrHoldsTheExactShiftFromAFewPeriods) {
    for (const double distance : {.3, .1, 1e-2, 1e-3, 1e-4}) {
        Case c = near_limit(distance, 2000);
        c.of<mdr::Settings>().springs = 3000;  // over 2 a + 2 W
        const History brief = contact::run(c, *mdr::make_model(c));
        EXPECT_EQ(brief.verdict.state, State::shakedown);
        EXPECT_TRUE(brief.verdict.by_limit);
        EXPECT_LE(brief.verdict.remaining_error, 1e-4);
        const double exact =
            *theory::bed_settled_shift_ratio(c, amplitude, *c.load.tangential_ratio);
        const double settled = shift_ratio(brief) + brief.verdict.remaining;
        // Kinks between the springs: dx^2/4 in f at dx = a/1200, and 1/distance^(1/2) in u.
        const double bed = 1.8e-7 / std::sqrt(distance);
        EXPECT_NEAR(settled, exact, brief.verdict.remaining_error + bed) << distance;
        c.rolling->periods = 10 * periods(brief);
        c.rolling->run_all = true;
        const History all = contact::run(c, *mdr::make_model(c));
        EXPECT_NEAR(settled, shift_ratio(all), brief.verdict.remaining_error) << distance;
        c.rolling->run_all = false;
        c.rolling->until = Case::Until::periods;
        if (distance < .1) {
            EXPECT_LT(periods(brief), .6 * periods(contact::run(c, *mdr::make_model(c))));
        }
    }
}

TEST(SettledRun, OfBemHoldsTheShiftOfALongerOne) {
    for (const double angle : {0., 1.2}) {
        Case c = near_limit(1e-2, 2000);
        c.rolling->angle = angle;
        c.contact.coupling = false;
        const History brief = contact::run(c, *bem::make_model(c, 1));
        EXPECT_TRUE(brief.verdict.by_limit);
        c.rolling->until = Case::Until::periods;
        c.rolling->periods = 10 * periods(brief);
        const History all = contact::run(c, *bem::make_model(c, 1));
        EXPECT_NEAR(shift_ratio(brief) + brief.verdict.remaining, shift_ratio(all),
                    brief.verdict.remaining_error);
        EXPECT_LT(periods(brief), .7 * periods(all));
    }
}

TEST(SettledRun, EndsWithAKnownIncrementOfRatcheting) {
    Case c = near_limit(-.1, 2000);
    const History brief = contact::run(c, *mdr::make_model(c));
    EXPECT_EQ(brief.verdict.state, State::ratcheting);
    const auto last = [](const History& h) {
        return h.shift_per_period.back() - *(h.shift_per_period.end() - 2);
    };
    c.rolling->until = Case::Until::periods;
    c.rolling->periods = 10 * periods(brief);
    EXPECT_LT(periods(brief), 100);
    EXPECT_NEAR(last(contact::run(c, *mdr::make_model(c))), last(brief), .01 * last(brief));
}

}  // namespace
}  // namespace tricontact::settled_run_test
