#include "comparisons/quantities/resample.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "report/document_csv.h"
#include "tests/unit/comparisons/nodes.h"

namespace tricontact::comparisons::resample_test {
namespace {

const auto coulomb_law = contact::Friction{.coefficient = 1}.law();
const contact::FrictionLaw& coulomb = *coulomb_law;

using contact::ContactState;
using contact::Surface;
using contact::Vector2;
using synthetic::Options;

/// Sheared, turned and unevenly stretched; keeps the origin.
Vector2 affine(double x, double y) {
    return {1.1 * x + 0.3 * y, -0.2 * x + 0.9 * y};
}
/// Sides of elements become unequal, lines stay lines within a quarter of an element only.
Vector2 wavy(double x, double y) {
    return {x + 0.05 * std::sin(3 * y), y + 0.04 * std::sin(2 * x + 1)};
}

Surface constant_surface(const Options& options) {
    return synthetic::surface(options, false, {0, 0});
}

TEST(Resample, LinearFieldsStayLinearOnAnyElements) {
    Surface s = synthetic::as_irregular_nodes(constant_surface({.n_x = 31, .n_y = 23}), wavy);
    for (std::size_t k = 0; k < s.size(); ++k) {
        s.displacement_x[k] = 2 + 3 * s.node_x[k] - 5 * s.node_y[k];
        s.contact_state[k] = ContactState::slip;
    }
    const Surface grid = Resampling(s)(s);
    ASSERT_TRUE(is_grid(grid));
    int covered = 0;
    for (int j = 0; j < grid.n_y; ++j)
        for (int i = 0; i < grid.n_x; ++i) {
            const std::size_t k = static_cast<std::size_t>(j) * grid.n_x + i;
            if (std::isnan(grid.displacement_x[k])) {
                EXPECT_EQ(grid.contact_state[k], ContactState::open);
                continue;
            }
            ++covered;
            EXPECT_EQ(grid.contact_state[k], ContactState::slip);
            // Bilinear elements hold linear fields exactly; Newton's method stops at 1e-13.
            EXPECT_NEAR(grid.displacement_x[k], 2 + 3 * grid.x(i) - 5 * grid.y(j), 1e-11);
        }
    // The surface is 3.2 x 3.2 but for the waves of its border; points are as dense as nodes.
    EXPECT_NEAR(covered * grid.spacing[0] * grid.spacing[1], 3.224 * 3.224, 0.05 * 3.224 * 3.224);
    EXPECT_NEAR(covered, 31 * 23, 0.1 * 31 * 23);
}

TEST(Resample, RegularNodesGiveTheirOwnValuesBack) {
    // Odd numbers of lines through the origin; the sheared grid's points fall between its nodes.
    const Surface grid = constant_surface({.w = 0, .n_x = 53, .n_y = 53});
    const Surface back = [&] {
        const Surface s = synthetic::as_irregular_nodes(grid, [](double x, double y) {
            return Vector2{x, y};
        });
        return Resampling(s)(s);
    }();
    ASSERT_EQ(back.n_x, 53);
    ASSERT_EQ(back.n_y, 53);
    EXPECT_NEAR(back.first[0], grid.first[0], 1e-12);
    for (std::size_t k = 0; k < grid.size(); ++k) {
        // Positions agree to rounding, which steep tractions at the edge magnify.
        EXPECT_NEAR(back.normal_traction[k], grid.normal_traction[k], 1e-10);
        EXPECT_NEAR(back.tangential_traction_x[k], grid.tangential_traction_x[k], 1e-10);
        EXPECT_EQ(back.contact_state[k], grid.contact_state[k]);
    }
}

TEST(Resample, FrictionBoundHoldsBetweenNodesAndForceIsKept) {
    Surface s = synthetic::as_irregular_nodes(constant_surface({.n_x = 81, .n_y = 81}), wavy);
    const auto p_of = [](double x, double y) { return std::sqrt(std::max(0., 1 - x * x - y * y)); };
    for (std::size_t k = 0; k < s.size(); ++k) {
        const double p = p_of(s.node_x[k], s.node_y[k]);
        s.normal_traction[k] = p;
        s.friction_bound[k] = 0.3 * p;
        s.tangential_traction_x[k] = 0.3 * p * std::cos(7 * s.node_x[k]);
        s.tangential_traction_y[k] = 0.3 * p * std::sin(7 * s.node_x[k]);
    }
    const Surface grid = Resampling(s)(s);
    double force = 0;
    for (std::size_t k = 0; k < grid.size(); ++k) {
        EXPECT_LE(std::hypot(grid.tangential_traction_x[k], grid.tangential_traction_y[k]),
                  grid.friction_bound[k] * (1 + 1e-12));
        force += grid.normal_traction[k] * grid.spacing[0] * grid.spacing[1];
    }
    // Half a ball, 2/3 pi, by squares of 0.04.
    EXPECT_NEAR(force, 2. / 3 * M_PI, 0.005);
}

TEST(Resample, OutsideTheElementsThereIsNothing) {
    const Surface s =
        synthetic::as_irregular_nodes(constant_surface({.n_x = 31, .n_y = 31}), affine);
    const Surface grid = Resampling(s)(s);
    // The box around the sheared square has free corners.
    EXPECT_TRUE(std::isnan(grid.displacement_x.front()));
    EXPECT_EQ(grid.normal_traction.front(), 0);
    EXPECT_EQ(grid.contact_state.front(), ContactState::open);
}

TEST(Resample, AGridPointLiesAtTheOrigin) {
    const Surface s =
        synthetic::as_irregular_nodes(constant_surface({.n_x = 21, .n_y = 31}), affine);
    const Surface grid = Resampling(s)(s);
    for (int d = 0; d < 2; ++d) {
        const double steps = -grid.first[d] / grid.spacing[d];
        EXPECT_NEAR(steps, std::round(steps), 1e-9);
    }
}

TEST(Resample, PicturesNeedNoMoreThan400Points) {
    Surface s = synthetic::as_irregular_nodes(constant_surface({.n_x = 21, .n_y = 21}),
                                              [](double x, double y) {
                                                  // Tiny elements about the centre.
                                                  return Vector2{x * x * x * x * x, y};
                                              });
    const Surface grid = Resampling(s)(s);
    EXPECT_LE(grid.n_x, 403);
    EXPECT_LE(grid.n_y, 403);
}

TEST(Resample, OnlyWhatIsNoGridIsResampled) {
    const auto histories = synthetic::two_models();
    const contact::History regular =
        synthetic::with_surfaces(histories[1], synthetic::as_regular_nodes);
    EXPECT_EQ(on_grids({regular})[0].snapshots.front().surface.layout, Surface::Layout::nodes);
    const contact::History irregular = synthetic::with_surfaces(
        histories[1], [](const Surface& s) { return synthetic::as_irregular_nodes(s, wavy); });
    const auto resampled = on_grids({histories[0], irregular});
    for (const auto& snapshot : resampled[1].snapshots)
        EXPECT_EQ(snapshot.surface.layout, Surface::Layout::grid);
    EXPECT_EQ(resampled[0].snapshots.front().surface.layout, Surface::Layout::line);
    for (std::size_t k = 0; k < irregular.snapshots.size(); ++k)
        EXPECT_EQ(resampled[1].snapshots[k].surface.offset, irregular.snapshots[k].surface.offset);
}

/// What the plots are made from, on the grid's own nodes and on sheared elements with the same
/// fields.
class NodesLayout : public testing::Test {
  protected:
    static contact::History history(const Options& options) {
        contact::History h = synthetic::loaded_history("fem", options);
        synthetic::add_snapshots(h, options, false);
        return h;
    }
    const Options options_{.f = 0.488, .rolling = false, .n_x = 101, .n_y = 101};  // c = 0.8 a
};

TEST_F(NodesLayout, RegularNodesAreReadLikeAGrid) {
    const contact::History grid = history(options_);
    const contact::History nodes = synthetic::with_surfaces(grid, synthetic::as_regular_nodes);
    EXPECT_EQ(zones(nodes, coulomb), zones(grid, coulomb));
    for (const Axis axis : {Axis::x, Axis::y}) {
        const CentreLine a = centre_line(grid, coulomb, axis),
                         b = centre_line(nodes, coulomb, axis);
        EXPECT_EQ(a.position, b.position);
        EXPECT_EQ(a.traction, b.traction);
        EXPECT_EQ(a.zone, b.zone);
    }
    const contact::Case c = synthetic::unit_case(options_);
    const auto expected = make_figures(c, {grid}), figures = make_figures(c, {nodes});
    ASSERT_EQ(figures.size(), expected.size());
    for (std::size_t i = 0; i < figures.size(); ++i) {
        EXPECT_EQ(figures[i].id, expected[i].id);
        EXPECT_EQ(report::figure_csv(figures[i]), report::figure_csv(expected[i]));
    }
}

TEST_F(NodesLayout, IrregularNodesShowTheSameZones) {
    contact::History h = synthetic::with_surfaces(history(options_), [](const Surface& grid) {
        Surface s = synthetic::as_irregular_nodes(grid, affine);
        for (std::size_t k = 0; k < s.size(); ++k) {  // fields of the unit case in their new places
            const double r = std::hypot(s.node_x[k], s.node_y[k]);
            const double p = 2 / M_PI * std::sqrt(std::max(0., 1 - r * r));
            const double t = r < 1 ? 2 / M_PI * theory::cattaneo_mindlin_traction(r, 0.488) : 0;
            s.normal_traction[k] = s.friction_bound[k] = p;
            s.tangential_traction_x[k] = t;
            s.contact_state[k] = p <= 0   ? ContactState::open
                                 : t >= p ? ContactState::slip
                                          : ContactState::stick;
        }
        return s;
    });
    const auto resampled = on_grids({h});
    for (const Axis axis : {Axis::x, Axis::y}) {
        const auto parts = stretches(centre_line(resampled[0], coulomb, axis));
        ASSERT_EQ(parts.size(), 5u);  // open, slip, stick, slip, open
        EXPECT_EQ(parts[2].zone, Zone::stick);
        // Elements of 0.04 a: two nodes on either side.
        EXPECT_NEAR(parts[2].begin, -0.8, 0.04);
        EXPECT_NEAR(parts[2].end, 0.8, 0.04);
        EXPECT_NEAR(parts[3].end, 1, 0.04);
    }
    std::vector<std::string> names;
    for (const report::Figure& figure : make_figures(synthetic::unit_case(options_), resampled))
        names.push_back(figure.id);
    EXPECT_EQ(names,
              (std::vector<std::string>{"traction_x", "traction_y", "zones_fem",
                                        "traction_surface_fem", "displacement_surface_fem"}));
}

TEST_F(NodesLayout, HolesBetweenElementsAreLeftOutOfThePicture) {
    // Small enough that corners of the picture, 1.15 a wide, are not covered.
    const auto shrunk = [](double x, double y) {
        const Vector2 p = affine(x, y);
        return Vector2{0.75 * p[0], 0.75 * p[1]};
    };
    const contact::History h = synthetic::with_surfaces(
        history({.rolling = false, .n_x = 31, .n_y = 31}),
        [&](const Surface& s) { return synthetic::as_irregular_nodes(s, shrunk); });
    const auto figures = surface_figures(synthetic::unit_case({.rolling = false}), on_grids({h}));
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_TRUE(
        std::ranges::any_of(figures[1].map->values, [](double u) { return std::isnan(u); }));
}

}  // namespace
}  // namespace tricontact::comparisons::resample_test
