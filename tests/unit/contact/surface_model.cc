#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/run.h"

namespace tricontact::surface_model_test {
namespace {

using contact::Case;
using contact::LoadStep;

/// A coupled contact on a bonded layer, cells of 0.6 mm.
Case layer_case() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .56;
    c.rolling = Case::Rolling{};
    c.rolling->amplitude_ratio = .24;
    c.rolling->steps = Case::Steps::turning_points;
    c.of<contact::Cells>().spacing = 6e-4;
    return c;
}

constexpr int n_periods = 8;

/// Pressed, loaded, and rolled.
std::vector<LoadStep> steps_of(const Case& c) {
    const auto path = contact::make_load_path(c, *c.load.normal_force, 4.4e-3);
    std::vector<LoadStep> steps = {contact::press_step(c), path.loading.front()};
    for (int n = 0; n < n_periods; ++n)
        for (LoadStep step : path.period) {
            step.phase += n;
            steps.push_back(step);
        }
    return steps;
}

/// Of steps_of(), by turning points.
bool starts_period(std::size_t step) {
    return step >= 2 && (step - 2) % 4 == 0;
}

std::unique_ptr<contact::Model> make_layer(const Case& c) {
    return bem::make_model(c, 1, bem::Body::layer);
}

// The starts of earlier periods save iterations and change nothing else.
TEST(SurfaceModel, StartsOfTheLastPeriodSaveIterations) {
    const Case c = layer_case();
    const auto model = make_layer(c), without = make_layer(c);
    int spent = 0, spent_without = 0;
    double unknown_phase = 0;
    const auto steps = steps_of(c);
    for (LoadStep step : steps) {
        const auto record = model->advance(step);
        const bool last_period = step.phase > n_periods - 1;
        step.phase = unknown_phase += .013;  // another one each time: no start is found
        const auto other = without->advance(step);
        EXPECT_NEAR(record.shift[0] / other.shift[0], 1, 1e-5);  // tolerance 1e-7 of d, added up
        EXPECT_NEAR(record.indentation / other.indentation, 1, 1e-6);
        if (!last_period) continue;
        spent += record.normal_iterations + record.tangential_iterations;
        spent_without += other.normal_iterations + other.tangential_iterations;
    }
    EXPECT_LT(spent, .6 * spent_without);
    EXPECT_TRUE(model->audit().passed());
}

// Nor does the error of a start add up from period to period: at rest is at rest, also where the
// solver is content with little.
TEST(SurfaceModel, StartsOfTheLastPeriodDoNotDrift) {
    Case c = layer_case();
    c.of<bem::Settings>().tolerance = 1e-5;
    c.load.tangential_ratio = .4;
    c.rolling->periods = 40;
    c.rolling->run_all = true;
    const auto history = contact::run(c, *make_layer(c));
    const auto& shift = history.shift_per_period;
    EXPECT_LT(std::abs(shift[39] - shift[29]) / 10, 2e-8 * history.scales.unit_shift);
}

// A run that goes on after a kill reads the states in their order and has the bits of one that was
// not killed.
TEST(SurfaceModel, GoesOnFromItsBytes) {
    const Case c = layer_case();
    const auto model = make_layer(c), resumed = make_layer(c);
    const auto steps = steps_of(c);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        for (auto* each : {model.get(), resumed.get()})
            if (starts_period(k)) each->start_period();
        model->advance(steps[k]);
        if (k < steps.size() / 2)
            resumed->read_state(model->write_state());
        else
            resumed->advance(steps[k]);
        ASSERT_EQ(resumed->write_state(), model->write_state()) << k;
        ASSERT_EQ(resumed->surface().slip_path, model->surface().slip_path) << k;
        ASSERT_EQ(resumed->surface().friction_work, model->surface().friction_work) << k;
    }
}

// Uncoupled contact comes back to places from either side: whatever way a resumed run comes, the
// pressures are those of the run that it continues.
TEST(SurfaceModel, UncoupledGoesOnFromItsBytes) {
    Case c = layer_case();
    c.layer.thickness.reset();
    c.rolling->steps = Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 3;
    const auto steps = steps_of(c);
    for (const std::size_t interrupted : {4, 6, 11}) {
        const auto model = bem::make_model(c, 1), resumed = bem::make_model(c, 1);
        for (std::size_t k = 0; k < 30; ++k) {
            model->advance(steps[k]);
            if (k <= interrupted)
                resumed->read_state(model->write_state());
            else
                resumed->advance(steps[k]);
            ASSERT_EQ(resumed->write_state(), model->write_state()) << interrupted << ' ' << k;
        }
    }
}

// What relaxes starts from pressures of the period before and from what the last step's have gained
// since: a run resumed in its third period knows both, and takes the same iterations. Where all of
// it relaxes, and where its bulk does not.
TEST(SurfaceModel, RelaxingGoesOnFromItsBytes) {
    Case c = layer_case();
    c.layer.thickness.reset();
    c.substrate.poisson = .45;
    c.contact.coupling = false;
    c.rolling->steps = Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 2;
    c.rolling->speed = 1e-3;
    c.relaxation = contact::Relaxation{{{.4, .3}, {.3, 3.}}, {}};
    for (const auto bulk :
         {contact::Relaxation::Bulk::elastic, contact::Relaxation::Bulk::proportional}) {
        c.relaxation->bulk = bulk;
        const auto steps = steps_of(c);
        for (const std::size_t interrupted : {9, 20, 23}) {
            const auto model = bem::make_model(c, 1), resumed = bem::make_model(c, 1);
            for (std::size_t k = 0; k < 34; ++k) {
                const auto record = model->advance(steps[k]);
                if (k <= interrupted)
                    resumed->read_state(model->write_state());
                else
                    ASSERT_EQ(resumed->advance(steps[k]).normal_iterations,
                              record.normal_iterations);
                ASSERT_EQ(resumed->write_state(), model->write_state()) << interrupted << ' ' << k;
            }
        }
    }
}

// Also at positions whose pressures are known from before. Tolerance of the solver: 1e-8 of d.
TEST(SurfaceModel, GapIsClosedWhereverTheContactHasRolled) {
    Case c = layer_case();
    for (const bool coupled : {true, false}) {
        c.contact.coupling = coupled;
        const auto model = make_layer(c);
        for (const LoadStep& step : steps_of(c)) {
            const double d = model->advance(step).indentation;
            const contact::Surface s = model->surface();
            double worst = 0;
            for (std::size_t i = 0; i < s.size(); ++i)
                worst = std::max(worst, s.normal_traction[i] > 0 ? std::abs(s.gap[i]) : -s.gap[i]);
            EXPECT_LT(worst, 1e-6 * d) << step.phase;
        }
    }
}

// The work on all points is what friction dissipates in the period, each period from zero.
TEST(SurfaceModel, FrictionalWorkOfAllPointsIsTheDissipationOfThePeriod) {
    Case c = layer_case();
    c.rolling->periods = 3;
    c.rolling->run_all = true;
    const auto history = contact::run(c, *make_layer(c));
    EXPECT_TRUE(history.snapshots.front().surface.slip_path.empty());  // not yet rolling
    int n_ends = 0;
    for (const auto& [phase, s] : history.snapshots) {
        if (phase != std::round(phase) || phase == 0) continue;
        const std::size_t n = std::lround(phase) - 1;
        double work = 0;
        for (const double each : s.friction_work) work += s.spacing[0] * s.spacing[1] * each;
        EXPECT_NEAR(work / history.dissipation_per_period[n], 1, 1e-12) << n;  // rounding of sums
        EXPECT_EQ(history.slip_path_per_period.at(n), std::ranges::max(s.slip_path));
        EXPECT_EQ(history.friction_work_per_period.at(n), std::ranges::max(s.friction_work));
        ++n_ends;
    }
    EXPECT_EQ(n_ends, 3);
}

}  // namespace
}  // namespace tricontact::surface_model_test
