// Histories without a factor beside those of the condensed layer, on the same mesh.

#include "fem/block/block_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/load_path.h"
#include "contact/run.h"
#include "fem/case/model.h"
#include "fem/one_blas_thread.h"
#include "fem/settings.h"

namespace tricontact::block_model_test {
namespace {

using contact::Case;

Case rolling_rig() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .3;
    c.load.press_steps = 1;
    Case::Rolling rolling;
    rolling.amplitude_ratio = .24;
    rolling.steps = Case::Steps::per_quarter;
    rolling.steps_per_quarter = 1;
    rolling.periods = 1;
    rolling.run_all = true;
    c.rolling = rolling;
    c.of<fem::Settings>().size = 2e-3;
    c.of<fem::Settings>().cache = "none";
    return c;
}

contact::History history(Case c, fem::Solver solver) {
    const fem::OneBlasThread one;  // others of the same machine wait for each other
    c.of<fem::Settings>().solver = solver;
    return contact::run(c, *fem::make_model(c, {}));
}

/// To the tolerance of both, of indentation and shift.
void expect_same(const Case& c) {
    const auto direct = history(c, fem::Solver::direct), other = history(c, fem::Solver::iterative);
    ASSERT_EQ(direct.steps.size(), other.steps.size());
    const double accuracy = 10 * c.of<fem::Settings>().tolerance * direct.scales.indentation;
    for (std::size_t k = 0; k < direct.steps.size(); ++k) {
        EXPECT_NEAR(other.steps[k].indentation, direct.steps[k].indentation, accuracy) << k;
        for (int d = 0; d < 2; ++d)
            EXPECT_NEAR(other.steps[k].shift[d], direct.steps[k].shift[d], accuracy) << k;
    }
    EXPECT_NEAR(other.scales.unit_shift / direct.scales.unit_shift, 1, 1e-6);
    EXPECT_TRUE(other.audit.passed());
}

TEST(BlockModel, HistoryIsThatOfTheCondensedLayer) {
    expect_same(rolling_rig());
}

// A run that was killed after its second step goes on in another process. To rounding, which in
// eigenvectors by LAPACK depends on where arrays lie.
TEST(BlockModel, GoesOnFromItsBytes) {
    const fem::OneBlasThread one;
    Case c = rolling_rig();
    c.of<fem::Settings>().solver = fem::Solver::iterative;
    const auto whole = fem::make_model(c, {}), resumed = fem::make_model(c, {});
    for (const auto& model : {whole.get(), resumed.get()}) model->release();
    contact::LoadStep step = contact::press_step(c);
    const auto slide = [&](contact::Model& model, double ratio) {
        step.tangential[0].value = ratio * *c.load.normal_force;
        return model.advance(step);
    };
    slide(*whole, .1);
    slide(*whole, .2);
    const std::string bytes = whole->write_state();
    resumed->read_state(bytes);
    EXPECT_TRUE(resumed->write_state() == bytes);
    const contact::StepRecord through = slide(*whole, .3), record = slide(*resumed, .3);
    EXPECT_NEAR(record.indentation / through.indentation, 1, 1e-12);
    EXPECT_NEAR(record.shift[0] / through.shift[0], 1, 1e-12);
    EXPECT_NEAR(record.dissipation / through.dissipation, 1, 1e-9);
}

// Loaded across the rolling direction: no half of the contact stands for the other; layers of two
// materials, one compressible, of finite width with its sides held, free to slide on the base.
TEST(BlockModelSlow, HistoryOfABlockOfTwoLayersThatSlides) {
    Case c = rolling_rig();
    c.layer.lower = {{4e-3, {3e6, .35}}};
    c.layer.thickness = 4e-3;
    c.layer.base = Case::Base::frictionless;
    c.layer.width = c.layer.depth = 50e-3;
    c.rolling->angle = .7;
    expect_same(c);
}

}  // namespace
}  // namespace tricontact::block_model_test
