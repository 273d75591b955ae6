// A run that begins again leaves nothing of what was before: what observes it counts from step 1.

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "comparisons/shakedown/limit_search.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::larger_grid_test {
namespace {

using contact::Case;

/// Springs that once, at the phase given, pretend to be too few.
class OnceAtEdge final : public contact::Model {
  public:
    OnceAtEdge(const Case& c, double phase) : springs_(mdr::make_model(c)), edge_(phase) {}

    std::string name() const override { return springs_->name(); }
    contact::StepRecord advance(const contact::LoadStep& step) override {
        if (edge_ && step.phase >= *edge_) throw contact::ContactAtEdge("the edge");
        return springs_->advance(step);
    }
    void release() override { springs_->release(); }
    void enlarge(const contact::ContactAtEdge&) override {
        edge_.reset();
        springs_->release();
    }
    contact::Scales scales() const override { return springs_->scales(); }
    contact::Surface surface() const override { return springs_->surface(); }
    double limit_tangential_ratio() const override { return springs_->limit_tangential_ratio(); }
    void start_limit() override { springs_->start_limit(); }
    const contact::Audit& audit() const override { return springs_->audit(); }

  private:
    std::unique_ptr<contact::Model> springs_;
    std::optional<double> edge_;
};

Case rolled() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    c.of<mdr::Settings>().springs = 100;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .3;
    c.rolling->periods = 5;
    c.rolling->run_all = true;
    c.rolling->steps = Case::Steps::turning_points;
    return c;
}

TEST(LargerGrid, HistoryIsThatOfTheSecondRun) {
    const Case c = rolled();
    OnceAtEdge model(c, 2.5);
    int n_begins = 0;
    const contact::History again = contact::run(
        c, model,
        [&](const auto&, auto&, const auto& progress) { n_begins += progress.step == 1; });
    EXPECT_EQ(n_begins, 2);
    const contact::History once = contact::run(c, *mdr::make_model(c));
    // Released springs keep their place and depth, from which the next are found: to rounding.
    ASSERT_EQ(again.shift_per_period.size(), once.shift_per_period.size());
    for (std::size_t n = 0; n < once.shift_per_period.size(); ++n) {
        EXPECT_NEAR(again.shift_per_period[n] / once.shift_per_period[n], 1, 1e-12) << n;
        EXPECT_NEAR(again.dissipation_per_period[n] / once.dissipation_per_period[n], 1, 1e-11)
            << n;
    }
    EXPECT_EQ(again.steps.size(), once.steps.size());
    EXPECT_EQ(again.snapshots.size(), once.snapshots.size());
    EXPECT_EQ(again.verdict.state, once.verdict.state);
}

TEST(LargerGrid, LimitIsThatOfTheSecondRuns) {
    const Case c = rolled();
    auto limit = [&](std::optional<double> edge) {
        return comparisons::search_limit(
            c, "mdr",
            [&](const Case& at) -> std::unique_ptr<contact::Model> {
                if (!edge) return mdr::make_model(at);
                return std::make_unique<OnceAtEdge>(at, *edge);
            },
            {comparisons::LimitVariable::load, 1e-2}, [](const std::string&) {});
    };
    const auto again = limit(2.5), once = limit({});
    ASSERT_EQ(again.runs.size(), once.runs.size());
    for (std::size_t k = 0; k < once.runs.size(); ++k) {
        EXPECT_EQ(again.runs[k].state, once.runs[k].state) << k;
        EXPECT_EQ(again.runs[k].periods, once.runs[k].periods) << k;
    }
}

}  // namespace
}  // namespace tricontact::larger_grid_test
