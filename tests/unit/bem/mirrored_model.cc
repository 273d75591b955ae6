// Half of a symmetric contact is the whole one.

#include <gtest/gtest.h>

#include <cmath>

#include "bem/grid_compliance.h"
#include "bem/model.h"
#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/compliances/active_operator.h"
#include "contact/run.h"
#include "contact/surface_model.h"

namespace tricontact::mirrored_model_test {
namespace {

contact::Case rolling(bool coupled) {
    contact::Case c;
    c.indenter.radius = 0.04;
    c.indenter.material = contact::Material{206e9, 0.3};
    c.substrate = {5.2e6, 0.5};
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = 0.24;
    c.of<contact::Cells>().spacing = 5e-4;
    c.of<bem::Settings>().tolerance = 1e-10;
    c.rolling->steps = contact::Case::Steps::per_quarter;
    c.rolling->steps_per_quarter = 3;
    c.rolling->periods = 2;
    c.rolling->run_all = true;
    if (!coupled) return c;
    c.indenter.material.reset();
    c.layer.thickness = 8e-3;
    c.load.press_steps = 2;
    return c;
}

// Solved to 1e-10, they are one solution to ten times that; tractions feel what is left of the
// displacements' residual a thousand times as much.
TEST(MirroredModel, IsHalfOfTheWholeOne) {
    for (const bool coupled : {false, true}) {
        const contact::Case c = rolling(coupled);
        ASSERT_TRUE(bem::is_mirrored(c));
        const auto body = coupled ? bem::Body::layer : bem::Body::half_space;
        contact::SurfaceModel whole("bem", *bem::make_substrate(c, 1, body), c.make_indenter(),
                                    c.friction.law(), c.of<bem::Settings>().tolerance, c.contact);
        const auto half = bem::make_model(c, 1, body);
        const auto a = contact::run(c, whole), b = contact::run(c, *half);
        ASSERT_EQ(a.steps.size(), b.steps.size());
        const double shift = 1e-9 * a.scales.unit_shift;
        for (std::size_t k = 0; k < a.steps.size(); ++k) {
            EXPECT_NEAR(a.steps[k].shift[0], b.steps[k].shift[0], shift) << k;
            EXPECT_NEAR(a.steps[k].normal_force / b.steps[k].normal_force, 1, 1e-9) << k;
            EXPECT_NEAR(a.steps[k].contact_area, b.steps[k].contact_area, 1e-12) << k;
            EXPECT_NEAR(a.steps[k].stored_energy / b.steps[k].stored_energy, 1, 1e-8) << k;
        }
        const auto s = whole.surface(), t = half->surface();
        ASSERT_EQ(s.n_x, t.n_x);
        ASSERT_EQ(s.n_y, t.n_y);
        EXPECT_NEAR(s.first[1], t.first[1], 1e-15);
        EXPECT_EQ(s.contact_state.size(), half->contact_states().size());
        for (std::size_t i = 0; i < s.size(); ++i) {
            EXPECT_NEAR(s.normal_traction[i], t.normal_traction[i], 1e-7 * a.scales.peak_pressure);
            EXPECT_NEAR(s.tangential_traction_x[i], t.tangential_traction_x[i],
                        1e-7 * a.scales.peak_pressure);
            EXPECT_NEAR(s.tangential_traction_y[i], t.tangential_traction_y[i],
                        1e-7 * a.scales.peak_pressure);
        }
    }
}

TEST(MirroredModel, OnlyWhereAllIsSymmetric) {
    EXPECT_TRUE(bem::is_mirrored(rolling(false)));
    contact::Case c = rolling(false);
    c.rolling->angle = .3;
    EXPECT_FALSE(bem::is_mirrored(c));
    c = rolling(false);
    c.indenter.roughness.emplace();
    EXPECT_FALSE(bem::is_mirrored(c));
    c = rolling(false);
    c.indenter.shape = contact::Case::Shape::roller;
    EXPECT_FALSE(bem::is_mirrored(c));
}

// A contact that is small on its grid has products of its own, which are the grid's.
TEST(ActiveOperator, OfAWindowIsTheGrids) {
    for (const bool mirrored : {false, true}) {
        const contact::Vector2 spacing{.1, .2};
        const auto grid = mirrored ? contact::ContactPoints::mirrored_grid(30, 12, -1.5, spacing)
                                   : contact::ContactPoints::grid(30, 23, {-1.5, -2.2}, spacing);
        const auto compliance = bem::half_space_compliance({{}, {3, .4}}, grid, 1);
        std::vector<std::size_t> active;
        for (std::size_t i = 0; i < grid.size(); ++i)
            if (std::hypot(grid.x[i] - .3, grid.y[i]) < .8) active.push_back(i);
        const auto window = compliance->among(active);
        ASSERT_TRUE(window);
        contact::TangentialField t(active.size()), u(active.size()), all_t(grid.size()),
            all_u(grid.size());
        for (std::size_t k = 0; k < active.size(); ++k) {
            const bool in_plane = mirrored && grid.y[active[k]] == 0;
            t.set(k, {std::sin(3. * k), in_plane ? 0 : std::cos(5. * k)});
            all_t.set(active[k], t.at(k));
        }
        window->apply(t, u);
        compliance->tangential(all_t, all_u);
        for (std::size_t k = 0; k < active.size(); ++k) {
            EXPECT_NEAR(u.x[k], all_u.x[active[k]], 1e-14);
            EXPECT_NEAR(u.y[k], all_u.y[active[k]], 1e-14);
        }
    }
}

}  // namespace
}  // namespace tricontact::mirrored_model_test
