// Where friction takes a contact off its grid, the run begins again on a larger one.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bem/model.h"
#include "bem/settings.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "contact/surface_model.h"

namespace tricontact::larger_grid_test {
namespace {

using contact::Case;

/// mu beta = 1.15 under a prescribed depth: the contact moves aside by more than a radius.
Case pushed_aside() {
    Case c;
    c.indenter.radius = 7.88e-6;
    c.substrate = {18.5e6, -.585};
    c.friction.coefficient = 1.68;
    c.load.indentation = 7e-11;
    c.load.tangential_ratio = .2167;
    c.load.press_steps = 2;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .1107;
    c.rolling->angle = std::numbers::pi / 2;
    c.rolling->periods = 1;
    c.rolling->steps = Case::Steps::turning_points;
    c.of<contact::Cells>().per_radius = 9.05;
    return c;
}

contact::SurfaceModel on_wide_grid(const Case& c) {
    return {"bem",
            *bem::make_substrate(c, 1, bem::Body::half_space, 1),
            c.make_indenter(),
            c.friction.law(),
            c.of<bem::Settings>().tolerance,
            c.contact};
}

// The same as from the start on a wide grid, whose cells are the same: to the tolerance of the
// turns, over d and mu d, which fewer than twenty steps add up.
void expect_as_on_a_wide_grid(const Case& c) {
    const auto model = bem::make_model(c, 1);
    const std::size_t first_size = model->surface().size();
    std::vector<int> begins;
    std::vector<std::size_t> sizes;
    const contact::History grown =
        contact::run(c, *model, [&](const auto&, auto& state, const auto& progress) {
            if (progress.step == 1) begins.push_back(static_cast<int>(sizes.size()));
            sizes.push_back(state.surface().size());
        });
    ASSERT_GE(begins.size(), 2U);  // it began again
    EXPECT_EQ(sizes.front(), first_size);
    EXPECT_EQ(sizes.size() - begins.back(), grown.steps.size());
    for (std::size_t k = begins.back(); k < sizes.size(); ++k) EXPECT_GT(sizes[k], first_size);
    for (const auto& snapshot : grown.snapshots)
        EXPECT_EQ(snapshot.surface.size(), sizes.back());  // none of the first grid
    EXPECT_TRUE(grown.audit.passed());

    auto wide = on_wide_grid(c);
    const contact::History expected = contact::run(c, wide);
    ASSERT_GT(wide.surface().size(), first_size);
    ASSERT_EQ(grown.steps.size(), expected.steps.size());
    const double d = expected.scales.indentation, f = expected.scales.normal_force;
    const double tolerance = 20 * c.of<bem::Settings>().tolerance;
    ASSERT_LT(expected.steps.size(), 20U);
    for (std::size_t k = 0; k < expected.steps.size(); ++k) {
        const auto &is = grown.steps[k], &should = expected.steps[k];
        EXPECT_NEAR(is.shift[0], should.shift[0], tolerance * c.friction_coefficient() * d) << k;
        EXPECT_NEAR(is.indentation, should.indentation, tolerance * d) << k;
        EXPECT_NEAR(is.normal_force, should.normal_force, tolerance * f) << k;
    }
}

TEST(BemLargerGrid, FollowsAContactThatFrictionPushesAside) {
    expect_as_on_a_wide_grid(pushed_aside());
}

TEST(BemLargerGrid, SiblingsHaveOneToo) {
    const Case c = pushed_aside();
    const auto other = bem::make_model(c, 1)->sibling(c.contact);
    EXPECT_TRUE(contact::run(c, *other).audit.passed());
}

TEST(BemLargerGrid, WithoutOneTheContactEndsAtTheEdge) {
    const Case c = pushed_aside();
    contact::SurfaceModel model("bem", *bem::make_substrate(c, 1, bem::Body::half_space),
                                c.make_indenter(), c.friction.law(),
                                c.of<bem::Settings>().tolerance, c.contact);
    EXPECT_THROW(contact::run(c, model), contact::ContactAtEdge);
}

TEST(BemLargerGrid, DoublesTheRoomUntilItIsTooMuch) {
    const contact::ContactAtEdge reached("bem: the edge");
    EXPECT_EQ(bem::more_room(0, reached), .5);
    EXPECT_EQ(bem::more_room(.5, reached), 1);
    EXPECT_EQ(bem::more_room(8, reached), 16);
    try {
        bem::more_room(16, reached);
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        EXPECT_STREQ(error.what(),
                     "bem: the edge, which has room for 16 half lengths of it on either side of "
                     "the body's path");
    }
}

}  // namespace
}  // namespace tricontact::larger_grid_test
