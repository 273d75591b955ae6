// What is left of friction in a coupled contact that has come to rest: nothing but slip at the rim,
// of points that touch and leave in each period, and that by the steps alone. A point that touches
// in a step is held where it was at the step's beginning; coupling has moved it since.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/run.h"

namespace tricontact::bem_rim_slip_test {
namespace {

using contact::Case;

struct LastPeriod {
    double work = 0;        ///< over mu F_N U_max
    double core_share = 0;  ///< of it, of points that stay in contact throughout
    int core_points = 0;    ///< their number
    double change = 0;      ///< of the work from the last period but one, over the work
};

// A steel ball of 15 mm on 3 mm of an elastomer that couples well, on cells two steps wide and
// more.
Case ball_on_layer() {
    Case c;
    c.indenter.radius = .015;
    c.substrate = {12e6, .3};
    c.layer.thickness = .003;
    c.friction.coefficient = .4;
    c.load.normal_force = 9;
    c.load.tangential_ratio = .5;
    c.load.press_steps = 5;
    c.rolling.emplace();
    c.rolling->amplitude = 4e-4;
    c.rolling->angle = 23 * std::numbers::pi / 180;
    c.rolling->periods = 24;  // the work of what comes to rest halves in each
    c.rolling->run_all = true;
    c.of<contact::Cells>().spacing = 1.6e-4;
    return c;
}

LastPeriod last_period(const Case& c) {
    const auto model = bem::make_model(c, 1, bem::Body::layer);
    std::vector<double> least, work;
    const auto watch = [&](const contact::StepRecord& step, const contact::Model& now,
                           const auto&) {
        if (step.phase <= c.rolling->periods - 1 + 1e-9) return;
        const contact::Surface surface = now.surface();
        if (least.empty()) least = surface.normal_traction;
        for (std::size_t i = 0; i < least.size(); ++i)
            least[i] = std::min(least[i], surface.normal_traction[i]);
        work = surface.friction_work;
    };
    const contact::History h = contact::run(c, *model, watch);
    const auto& w = h.dissipation_per_period;
    LastPeriod last;
    last.work = w.back() / (h.friction_limit * h.scales.unit_shift);
    last.change = std::abs(w.back() - w[w.size() - 2]) / w.back();
    double all = 0, core = 0;
    for (std::size_t i = 0; i < least.size(); ++i) {
        all += work[i];
        if (!(least[i] > 0)) continue;
        core += work[i];
        ++last.core_points;
    }
    last.core_share = core / all;
    return last;
}

LastPeriod with_steps(int steps_per_quarter) {
    Case c = ball_on_layer();
    c.rolling->steps_per_quarter = steps_per_quarter;
    return last_period(c);
}

TEST(BemRimSlip, FallsWithTheSquareOfTheStep) {
    const LastPeriod coarse = with_steps(6), middle = with_steps(12), fine = with_steps(24);
    for (const LastPeriod& last : {coarse, middle, fine}) {
        // It stands, so that no number of periods would end it.
        EXPECT_LT(last.change, 1e-3);
        // All that stays in contact sticks but for what is left of coming to rest.
        EXPECT_GT(last.core_points, 100);
        EXPECT_LT(last.core_share, 1e-3);
    }
    EXPECT_GT(coarse.work, 1e-5);
    // Points touch in a step with a pressure and after a way that go with its length. Single points
    // make up the sum, so that the order is one to a few tenths.
    EXPECT_NEAR(std::log2(coarse.work / middle.work), 2, .3);
    EXPECT_NEAR(std::log2(middle.work / fine.work), 2, .3);
}

// Of the solvers' tolerance it knows nothing: slips of ten tolerances are a thousandth of it.
TEST(BemRimSlip, IsNotTheTolerance) {
    Case c = ball_on_layer();
    const double usual = last_period(c).work;
    c.of<bem::Settings>().tolerance = 1e-9;
    EXPECT_NEAR(last_period(c).work / usual, 1, 1e-2);
}

TEST(BemRimSlip, NeedsCoupling) {
    Case c = ball_on_layer();
    c.contact.coupling = false;
    EXPECT_EQ(last_period(c).work, 0);
}

}  // namespace
}  // namespace tricontact::bem_rim_slip_test
