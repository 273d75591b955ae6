#include "contact/run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "contact/base/error.h"

namespace tricontact::run_test {
namespace {

using contact::Case;
using contact::LoadStep;
using contact::StepRecord;

/// Shifts by .2 under load and by .1 ratio^n in the n-th period, spread over its steps; dissipates
/// as much times mu F_N. Units: mu F_N = 10 N, U_max = 1 m.
class GeometricModel final : public contact::Model {
  public:
    explicit GeometricModel(double ratio) : ratio_(ratio) {}

    std::string name() const override { return "geometric"; }
    StepRecord advance(const LoadStep& step) override {
        steps.push_back(step);
        StepRecord record;
        record.phase = step.phase;
        record.normal_force = step.normal.value;
        record.tangential_force[0] = step.tangential[0].value;
        const double before = shift_;
        if (step.tangential[0].value > 0) shift_ = std::max(shift_, .2);
        if (step.phase > 0) {
            const double period = std::ceil(step.phase);
            shift_ += .1 * std::pow(ratio_, period) / steps_per_period;
            record.dissipation = 10 * (shift_ - before);
        }
        record.shift[0] = shift_;
        path_ += shift_ - before;
        audit_.record("sound", step.phase > fails_after ? 2e-3 : 0, 1e-6);
        return record;
    }
    void release() override { shift_ = 0; }
    void start_period() override { path_ = 0; }
    contact::Scales scales() const override { return {20, 1, 1, 1, 1}; }
    contact::Surface surface() const override {
        contact::Surface s;
        s.offset = steps.back().offset;
        s.slip_path = {path_ / 2, path_, 0};
        s.friction_work = {0, path_, 7 * path_};
        return s;
    }
    /// Beyond or below f_T = .3, as the increments are.
    double limit_tangential_ratio() const override {
        return (ratio_ < 1 ? .5 : .1) + limit_started_at / 100.;
    }
    void start_limit() override { limit_started_at = static_cast<int>(steps.size()); }
    const contact::Audit& audit() const override { return audit_; }

    std::vector<LoadStep> steps;
    int limit_started_at = 0;
    double fails_after = 1e9;
    static constexpr int steps_per_period = 8;

  private:
    double ratio_, shift_ = 0, path_ = 0;
    contact::Audit audit_;
};

Case rolling_case(int periods) {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {3e6, .5};
    c.friction.coefficient = .5;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .3;
    c.rolling.emplace();
    c.rolling->amplitude = .3;
    c.rolling->periods = periods;
    c.rolling->steps_per_quarter = 2;
    return c;
}

TEST(Run, KeepsTheBooks) {
    GeometricModel model(.9);
    const contact::History h = contact::run(rolling_case(5), model);
    EXPECT_EQ(h.model, "geometric");
    ASSERT_EQ(h.steps.size(), 2u + 5 * 8);
    ASSERT_EQ(model.steps.size(), h.steps.size());
    EXPECT_EQ(model.steps[0].tangential[0].value, 0);         // pressed
    EXPECT_DOUBLE_EQ(model.steps[1].tangential[0].value, 3);  // loaded
    EXPECT_DOUBLE_EQ(h.tangential_force, 3);
    EXPECT_DOUBLE_EQ(h.friction_limit, 10);
    EXPECT_DOUBLE_EQ(h.amplitude, .3);
    EXPECT_DOUBLE_EQ(h.static_shift, .2);
    ASSERT_EQ(h.shift_per_period.size(), 5u);
    ASSERT_EQ(h.dissipation_per_period.size(), 5u);
    double shift = .2;
    for (int n = 1; n <= 5; ++n) {
        shift += .1 * std::pow(.9, n);
        EXPECT_NEAR(h.shift_per_period[n - 1], shift, 1e-14);
        EXPECT_NEAR(h.dissipation_per_period[n - 1], std::pow(.9, n), 1e-13);
        EXPECT_NEAR(h.slip_path_per_period.at(n - 1), .1 * std::pow(.9, n), 1e-14);
        EXPECT_NEAR(h.friction_work_per_period.at(n - 1), .7 * std::pow(.9, n), 1e-13);
        // roller upright at the end of each period, phases count on
        EXPECT_EQ(h.steps[1 + 8 * n].phase, n);
        EXPECT_EQ(model.steps[1 + 8 * n].offset[0], 0);
    }
    EXPECT_EQ(h.limit_tangential_ratio, .52);  // watched from the end of loading on
    EXPECT_EQ(h.verdict.state, contact::State::shakedown);
    EXPECT_TRUE(h.verdict.by_limit);
    EXPECT_NEAR(h.verdict.remaining, .1 * std::pow(.9, 6) / (1 - .9), h.verdict.remaining_error);
    EXPECT_TRUE(h.audit.passed());
    EXPECT_EQ(h.audit.checks().size(), 1u);
}

// The model's limit is over F_N where rolling begins, the ratio of the case over the mean F_N: with
// an oscillation that leads by a quarter of its period the one is 1.2 times the other.
TEST(Run, LimitIsOverTheMeanNormalForce) {
    Case c = rolling_case(1);
    c.load.normal_amplitude_ratio = .2;
    c.load.normal_phase = std::numbers::pi / 2;
    GeometricModel model(.9);
    const contact::History h = contact::run(c, model);
    EXPECT_DOUBLE_EQ(h.steps[1].normal_force, 24);
    EXPECT_DOUBLE_EQ(h.limit_tangential_ratio, 1.2 * model.limit_tangential_ratio());
}

TEST(Run, StopsWhenSettledUnlessToldToGoOn) {
    GeometricModel model(.01), patient(.01);
    // .1 * .01^n < 1e-7 from n = 4 on
    const auto stopped = contact::run(rolling_case(12), model);
    EXPECT_EQ(stopped.shift_per_period.size(), 4u);
    EXPECT_EQ(stopped.verdict.state, contact::State::shakedown);
    Case c = rolling_case(12);
    c.rolling->run_all = true;
    const auto all = contact::run(c, patient);
    EXPECT_EQ(all.shift_per_period.size(), 12u);
    EXPECT_EQ(all.verdict.state, contact::State::shakedown);
}

TEST(Run, RatchetingIsSeenAndRunToTheEnd) {
    GeometricModel model(1);
    const auto h = contact::run(rolling_case(9), model);
    EXPECT_EQ(h.shift_per_period.size(), 9u);
    EXPECT_EQ(h.verdict.state, contact::State::ratcheting);
    EXPECT_NEAR(h.verdict.remaining_error, 0, 1e-6);
}

TEST(Run, UntilSettledEndsWhenTheRestIsKnown) {
    GeometricModel settling(.5), ratcheting(1);
    Case c = rolling_case(60);
    c.rolling->until = Case::Until::settled;
    const auto h = contact::run(c, settling);
    // .1 * .5^n is to come, of which a tenth is not known: below 1e-4 with n = 7
    EXPECT_EQ(h.shift_per_period.size(), 7u);
    EXPECT_NEAR(h.shift_per_period.back() + h.verdict.remaining, .3, h.verdict.remaining_error);
    EXPECT_LT(contact::run(c, ratcheting).shift_per_period.size(), 12u);
    c.rolling->run_all = true;
    EXPECT_EQ(contact::run(c, settling).shift_per_period.size(), 60u);
}

// Undecided by its periods alone: no point sticks, as its surface has none.
TEST(Run, UntilDecidedLeavesTheLimitAlone) {
    GeometricModel model(.5);
    const auto h = contact::run(rolling_case(30), model, {}, 1e-5);
    EXPECT_EQ(h.shift_per_period.size(), 30u);
    EXPECT_EQ(h.verdict.state, contact::State::undecided);
    EXPECT_FALSE(h.verdict.by_limit);
    EXPECT_TRUE(h.snapshots.empty());
    GeometricModel ratcheting(1);
    EXPECT_EQ(contact::run(rolling_case(30), ratcheting, {}, 1e-5).shift_per_period.size(), 5u);
}

std::vector<double> snapshot_phases(const contact::History& h) {
    std::vector<double> phases;
    for (const auto& snapshot : h.snapshots) phases.push_back(snapshot.phase);
    return phases;
}

TEST(Run, SnapshotsOfQuartersInTheFirstThreeAndTheLastPeriod) {
    std::vector<double> expected{0};
    for (int k = 1; k <= 12; ++k) expected.push_back(k / 4.);
    GeometricModel brief(1);
    EXPECT_EQ(snapshot_phases(contact::run(rolling_case(3), brief)), expected);
    for (const double phase : {8.25, 8.5, 8.75, 9.}) expected.push_back(phase);
    GeometricModel ratcheting(1);
    const auto h = contact::run(rolling_case(9), ratcheting);
    EXPECT_EQ(snapshot_phases(h), expected);
    EXPECT_DOUBLE_EQ(h.snapshots[1].surface.offset[0], .3);  // of the state at that phase
    EXPECT_DOUBLE_EQ(h.snapshots[15].surface.offset[0], -.3);
    // Settled before the last period allowed: that one is the last.
    GeometricModel settling(.2);  // below 1e-7 at n = 9
    const auto settled = contact::run(rolling_case(50), settling);
    EXPECT_EQ(settled.shift_per_period.size(), 9u);
    EXPECT_EQ(snapshot_phases(settled), expected);
}

TEST(Run, ObserverSeesEveryStep) {
    GeometricModel model(1);
    std::vector<contact::Progress> seen;
    std::vector<double> phases;
    contact::run(
        rolling_case(2), model,
        [&](const StepRecord& record, const contact::Model& m, const contact::Progress& progress) {
            EXPECT_EQ(&m, &model);
            phases.push_back(record.phase);
            seen.push_back(progress);
        });
    ASSERT_EQ(seen.size(), 18u);
    for (int k = 0; k < 18; ++k) {
        EXPECT_EQ(seen[k].step, k + 1);
        EXPECT_EQ(k > 0 ? seen[k].steps_at_most : 18, 18) << k;  // not known before pressing
        EXPECT_EQ(seen[k].quarter, k > 0 && k % 2 == 1) << k;    // 2 steps per quarter
    }
    EXPECT_EQ(phases.back(), 2);
}

TEST(Run, StaticCase) {
    Case c = rolling_case(1);
    c.rolling.reset();
    GeometricModel model(1);
    const auto h = contact::run(c, model);
    EXPECT_EQ(h.steps.size(), 2u);
    EXPECT_DOUBLE_EQ(h.static_shift, .2);
    EXPECT_TRUE(h.shift_per_period.empty());
    EXPECT_EQ(h.snapshots.size(), 1u);
}

// Where F_N follows from the indentation, here 20 N/m times it, all of the path is pressed first.
TEST(Run, SlidingUnderAnOscillatingIndentationIsRefusedBeforeTheFirstStep) {
    Case c = rolling_case(3);
    c.load.normal_force.reset();
    c.load.indentation = 20;
    c.load.normal_amplitude_ratio = .5;
    c.load.tangential_ratio = .45;
    GeometricModel model(.9), sliding(.9);
    EXPECT_EQ(contact::run(c, model).steps.size(), 2u + 3 * 8);
    c.load.tangential_ratio = .5;  // at the trough F_N is half of its mean
    bool seen = false;
    try {
        contact::run(c, sliding, [&](const auto&...) { seen = true; });
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "load: the tangential force 5 N reaches the friction limit mu F_N = 5 N at "
                     "phase 0.75; lower tangential_force, tangential_ratio or limit_fraction (or "
                     "their amplitude)");
    }
    EXPECT_FALSE(seen);
}

TEST(Run, FailedAuditEndsTheRun) {
    GeometricModel model(1);
    model.fails_after = 1.2;
    try {
        contact::run(rolling_case(3), model);
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        EXPECT_STREQ(error.what(),
                     "geometric: the solution at phase 1.25 fails its audit: sound is 2.00e-03, "
                     "allowed 1.0e-06");
    }
}

}  // namespace
}  // namespace tricontact::run_test
