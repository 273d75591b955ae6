#include "bem/model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bem/grid_compliance.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "contact/surface_model.h"

namespace tricontact::model_test {
namespace {

using contact::Case;

Case small_case() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    c.of<contact::Cells>().per_radius = 8;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .4;
    c.rolling->periods = 1;
    c.rolling->steps = Case::Steps::turning_points;
    return c;
}

contact::Surface pressed_surface(const Case& c) {
    const auto model = bem::make_model(c, 1);
    model->advance(contact::press_step(c));
    return model->surface();
}

// What has not relaxed yet has to be on the grid: 30 % of the resistance come from there.
TEST(BemModel, GridSeesWhatARelaxingSurfaceRemembersAheadOfTheContact) {
    Case c = small_case();
    c.rolling.reset();
    c.relaxation = {{{.3, .7}}};
    const double a = contact::half_space_scales(c).contact_radius;
    auto reach = [&] {
        const auto grid = bem::make_substrate(c, 1, bem::Body::half_space);
        return -grid->relaxed().points().first[0] / a;
    };
    c.tractive_rolling.emplace();
    EXPECT_LT(reach(), 1.5);
    c.tractive_rolling->speed = a;
    EXPECT_GT(reach(), 8);
    EXPECT_LT(reach(), 10);
}

/// Its bodies couple normal and tangential contact: friction changes F_N under a prescribed depth.
Case coupled_under_a_depth() {
    Case c = small_case();
    c.substrate.poisson = .3;
    c.load.press_steps = 5;
    c.load.indentation = contact::half_space_scales(c).indentation;
    c.load.normal_force.reset();
    return c;
}

// As CONTACT takes FX, over F_N of the step; then F_T stays.
TEST(BemModel, TangentialRatioIsThatOfTheLoadedContactUnderADepth) {
    const Case c = coupled_under_a_depth();
    const auto model = bem::make_model(c, 1);
    const contact::History h = contact::run(c, *model);
    const contact::StepRecord& loaded = h.steps[c.load.press_steps];
    EXPECT_EQ(loaded.phase, 0);
    EXPECT_NEAR(loaded.tangential_force[0] / (c.friction_coefficient() * loaded.normal_force), .5,
                1e-9);
    EXPECT_GT(loaded.normal_force, 1.005 * h.scales.normal_force);  // of pressing without friction
    EXPECT_NEAR(h.tangential_force / h.friction_limit, .5, 1e-9);
    EXPECT_GT(h.steps.size(), 8U);
    for (std::size_t k = c.load.press_steps; k < h.steps.size(); ++k)
        EXPECT_NEAR(h.steps[k].tangential_force[0] / loaded.tangential_force[0], 1, 1e-9);
}

// Under the F_N that a depth comes to, the same ratio shifts as far, but for the way of pressing.
TEST(BemModel, DepthAndForceShiftAlike) {
    Case c = coupled_under_a_depth();
    c.rolling.reset();
    const auto by_depth = contact::run(c, *bem::make_model(c, 1)).steps.back();
    c.load.normal_force = by_depth.normal_force;
    c.load.indentation.reset();
    const auto by_force = contact::run(c, *bem::make_model(c, 1)).steps.back();
    EXPECT_NEAR(by_depth.shift[0] / by_force.shift[0], 1, 2e-3);
    EXPECT_NEAR(by_depth.indentation / by_force.indentation, 1, 1e-3);
}

TEST(BemModel, GridFitsContactAndPath) {
    for (const double angle : {0., std::numbers::pi / 2, .7}) {
        Case c = small_case();
        c.rolling->angle = angle;
        const double a = contact::half_space_scales(c).contact_radius;
        const auto s = pressed_surface(c);
        EXPECT_EQ(s.layout, contact::Surface::Layout::grid);
        EXPECT_DOUBLE_EQ(s.spacing[0], a / 8);
        EXPECT_DOUBLE_EQ(s.spacing[1], a / 8);
        const int n[] = {s.n_x, s.n_y};
        const double along[] = {std::cos(angle), std::sin(angle)};
        for (int d = 0; d < 2; ++d) {
            EXPECT_EQ(n[d] % 2, 1);
            EXPECT_NEAR(s.first[d] + n[d] / 2 * s.spacing[d], 0, 1e-12 * a);  // a cell's centre
            const double needed = a * (1 + .4 * std::abs(along[d]));
            EXPECT_GT(-s.first[d], needed);
            EXPECT_LT(-s.first[d], needed + .1 * a + s.spacing[d]);
        }
        const auto model = bem::make_model(c, 1);
        EXPECT_TRUE(contact::run(c, *model).audit.passed());  // and never reaches the edge
    }
}

TEST(BemModel, SpacingAsGiven) {
    Case c = small_case();
    c.of<contact::Cells>().per_radius.reset();
    c.of<contact::Cells>().spacing = 7e-4;
    EXPECT_EQ(pressed_surface(c).spacing, (contact::Vector2{7e-4, 7e-4}));
}

TEST(BemModel, GridFitsOscillatingLoads) {
    for (const bool by_force : {true, false}) {
        Case c = small_case();
        c.load.normal_amplitude_ratio = .6;
        c.load.normal_phase = 1;
        c.load.tangential_ratio = .2;
        if (!by_force) {
            c.load.indentation = contact::half_space_scales(c).indentation;
            c.load.normal_force.reset();
        }
        const auto model = bem::make_model(c, 1);
        const auto h = contact::run(c, *model);
        EXPECT_TRUE(h.audit.passed());
        EXPECT_EQ(h.steps.size(), 6u);
    }
}

TEST(BemModel, AmplitudeInTheModelsOwnRadius) {
    Case c = small_case();
    c.rolling->amplitude_reference = Case::AmplitudeReference::model;
    const auto model = bem::make_model(c, 1);
    const auto h = contact::run(c, *model);
    EXPECT_DOUBLE_EQ(h.amplitude, .4 * h.scales.contact_radius);
    c.rolling->amplitude_reference = Case::AmplitudeReference::hertz;
    const auto other = bem::make_model(c, 1);
    EXPECT_DOUBLE_EQ(contact::run(c, *other).amplitude,
                     .4 * contact::half_space_scales(c).contact_radius);
}

TEST(BemModel, RefusesGridsBeyondMemory) {
    Case c = small_case();
    c.of<contact::Cells>().per_radius = 1e4 + .1;  // 14800.1 and 10801.1 cells either side
    try {
        bem::make_model(c, 1);
        FAIL() << "no error";
    } catch (const contact::InputError& error) {
        EXPECT_STREQ(error.what(),
                     "bem: the grid would have 29603 x 21603 cells, more than 16777216; enlarge "
                     "bem.spacing or shorten the rolling path");
    }
}

contact::SurfaceModel model_on(int cells) {
    const Case c = small_case();
    const double h = contact::half_space_scales(c).contact_radius / 8;
    const auto grid =
        contact::ContactPoints::grid(cells, cells, {-(cells / 2) * h, -(cells / 2) * h}, {h, h});
    return {"bem", bem::half_space_compliance(c.materials(), grid, 1), c.make_indenter(),
            c.friction.law(), 1e-7};
}

TEST(SurfaceModel, SaysWhenTheContactReachesTheEdge) {
    contact::LoadStep step;
    step.normal.value = 21.1;
    EXPECT_THROW(model_on(15).advance(step), contact::ContactAtEdge);
    auto model = model_on(21);
    EXPECT_NO_THROW(model.advance(step));
    step.offset = {0, contact::half_space_scales(small_case()).contact_radius / 2};
    EXPECT_THROW(model.advance(step), contact::ContactAtEdge);
}

TEST(SurfaceModel, RecordAndSurfaceSayTheSame) {
    auto model = model_on(25);
    contact::LoadStep step;
    step.normal.value = 21.1;
    model.advance(step);
    const double limit = .57 * 21.1;
    step.tangential[0].value = .6 * limit;
    step.tangential[1].value = -.3 * limit;
    const auto r = model.advance(step);
    const auto s = model.surface();
    const double cell = s.spacing[0] * s.spacing[1];
    double normal = 0, x = 0, y = 0, dissipation = 0;
    int count[3] = {0, 0, 0};
    for (std::size_t i = 0; i < s.size(); ++i) {
        normal += cell * s.normal_traction[i];
        x += cell * s.tangential_traction_x[i];
        y += cell * s.tangential_traction_y[i];
        dissipation += cell * s.dissipation[i];
        ++count[static_cast<int>(s.contact_state[i])];
        EXPECT_EQ(s.friction_bound[i], .57 * s.normal_traction[i]);
        // where it touches there is no gap, elsewhere a gap and no load
        const bool touches = s.normal_traction[i] > 0;
        EXPECT_EQ(touches, s.contact_state[i] != contact::ContactState::open);
        EXPECT_GE(s.gap[i], -1e-8 * r.indentation);
        EXPECT_LE(touches ? s.gap[i] : 0, 1e-8 * r.indentation);
        // a point that sticks goes with the indenter
        const bool sticks = s.contact_state[i] == contact::ContactState::stick;
        EXPECT_NEAR(sticks ? s.displacement_x[i] / r.shift[0] : 1, 1, 1e-5);
    }
    EXPECT_NEAR(normal, r.normal_force, 1e-12 * normal);
    EXPECT_NEAR(x, r.tangential_force[0], 1e-12 * limit);
    EXPECT_NEAR(y, r.tangential_force[1], 1e-12 * limit);
    EXPECT_NEAR(x, .6 * limit, 1e-9 * limit);
    EXPECT_NEAR(y, -.3 * limit, 1e-9 * limit);
    EXPECT_NEAR(dissipation, r.dissipation, 1e-12 * dissipation);
    EXPECT_NEAR(r.open_area, count[0] * cell, 1e-12);
    EXPECT_NEAR(r.stick_area, count[1] * cell, 1e-12);
    EXPECT_NEAR(r.slip_area, count[2] * cell, 1e-12);
    EXPECT_GT(count[1], 20);
    EXPECT_GT(count[2], 20);
    EXPECT_NEAR(r.contact_area, r.stick_area + r.slip_area, 1e-18);
}

// The slip condition: none where a point sticks, along the traction elsewhere. Loads that turn back
// leave most points sticking, with slips of either sign below the solver's tolerance.
TEST(SurfaceModel, FrictionNeverGivesEnergyBack) {
    auto model = model_on(25);
    contact::LoadStep step;
    step.normal.value = 21.1;
    model.advance(step);
    const double limit = .57 * 21.1;
    for (const double ratio : {.6, .3, -.2, -.6, -.5, .1, .7}) {
        step.tangential[0].value = ratio * limit;
        step.tangential[1].value = .4 * ratio * ratio * limit;
        const auto record = model.advance(step);
        EXPECT_GE(record.dissipation, 0);
        const auto s = model.surface();
        int n_sticking = 0;
        for (std::size_t i = 0; i < s.size(); ++i) {
            EXPECT_GE(s.dissipation[i], 0) << ratio;
            if (s.contact_state[i] == contact::ContactState::slip) {
                EXPECT_GT(s.dissipation[i], 0);
                continue;
            }
            EXPECT_EQ(std::abs(s.slip_x[i]) + std::abs(s.slip_y[i]) + s.dissipation[i], 0);
            n_sticking += s.contact_state[i] == contact::ContactState::stick;
        }
        EXPECT_GT(n_sticking, 20);
    }
}

TEST(SurfaceModel, ShiftControlReachesTheShift) {
    auto by_force = model_on(25), by_shift = model_on(25);
    contact::LoadStep step;
    step.normal.value = 21.1;
    by_force.advance(step);
    by_shift.advance(step);
    double reached = 0;
    for (const double part : {.3, .7, -.2}) {
        step.tangential[0] = {contact::TangentialControl::Kind::force, part * .57 * 21.1};
        reached = by_force.advance(step).shift[0];
        step.tangential[0] = {contact::TangentialControl::Kind::shift, reached};
        const auto r = by_shift.advance(step);
        EXPECT_NEAR(r.shift[0], reached, 1e-15 * std::abs(reached));
        EXPECT_NEAR(r.tangential_force[0] / (.57 * 21.1), part, 1e-6);  // tolerance 1e-7, thrice
    }
}

}  // namespace
}  // namespace tricontact::model_test
