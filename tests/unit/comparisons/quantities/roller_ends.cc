// The outline of a roller's contact, of surfaces whose edges are known.

#include "comparisons/quantities/roller_ends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/run/figures.h"

namespace tricontact::comparisons::roller_ends_test {
namespace {

using contact::ContactState;

constexpr double length = 20, growth = .3, decay = 1.5;  // a = 1 at half length

/// A dog-bone: wider by growth exp(-distance/decay).
double half_width(double y) {
    return 1 + growth * std::exp(-(length / 2 - std::abs(y)) / decay);
}

/// Hertz' line contact of the half width of each y; nothing touches beyond the ends.
void add_point(contact::Surface& s, double x, double y) {
    const double a = half_width(y), ratio = std::abs(x) / a;
    const bool touches = ratio < 1 && std::abs(y) <= length / 2;
    s.contact_state.push_back(touches ? ContactState::stick : ContactState::open);
    s.normal_traction.push_back(touches ? a * std::sqrt(1 - ratio * ratio) : 0);
    // Johnson (1985), eq. 4.36 integrated.
    s.gap.push_back(ratio > 1 ? a * a * (ratio * std::sqrt(ratio * ratio - 1) - std::acosh(ratio))
                              : 0);
}

contact::Surface on_grid(double h) {
    contact::Surface s;
    s.n_x = 2 * static_cast<int>(2 / h) + 1;
    s.n_y = static_cast<int>(1.2 * length / h);
    s.spacing = {h, h};
    s.first = {-(s.n_x - 1) / 2 * h, -(s.n_y - 1) / 2. * h};
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) add_point(s, s.x(i), s.y(j));
    return s;
}

/// Half of it, y >= 0, rows finer and finer towards the end.
contact::Surface on_nodes(double h) {
    contact::Surface s;
    s.layout = contact::Surface::Layout::nodes;
    for (int j = 0; j <= 40; ++j)
        for (double x = -2; x < 2 + h / 2; x += h) {
            const double share = j / 40.;
            s.node_x.push_back(x);
            s.node_y.push_back(length / 2 * share * (2 - share));
            add_point(s, s.node_x.back(), s.node_y.back());
        }
    return s;
}

contact::History upright(const contact::Surface& surface) {
    contact::History history;
    history.snapshots.push_back({0, surface});
    return history;
}

contact::Case roller() {
    contact::Case c;
    c.indenter.shape = contact::Case::Shape::roller;
    c.indenter.length = length;
    return c;
}

TEST(RollerEnds, EdgesLieBetweenThePoints) {
    for (const auto& surface : {on_grid(.2), on_nodes(.125)}) {
        const auto sections = roller_sections(surface, length);
        ASSERT_GT(sections.size(), 40u);
        for (const RollerSection& s : sections) {
            const double due = half_width(length / 2 - s.distance);
            // What the gap has beyond its first power, of points up to 0.4 a away: 0.7 %.
            EXPECT_NEAR(s.half_width / due, 1, 8e-3) << s.distance;
            EXPECT_NEAR(s.pressure, due, 1e-12);
        }
    }
}

TEST(RollerEnds, WidestAndReachOfADogBone) {
    const double reach = decay * std::log(growth / .01);
    const auto nodes = roller_ends(roller(), upright(on_nodes(.05))).value();
    EXPECT_NEAR(nodes.middle_half_width, half_width(0), 1e-3);
    EXPECT_NEAR(nodes.widest_ratio, (1 + growth) / half_width(0), 1e-3);
    EXPECT_EQ(nodes.knuckle, nodes.reach);  // it is narrower nowhere
    EXPECT_NEAR(nodes.reach, reach, .1);    // 1e-3 of the width, where it falls by 1/150 per length
    // The grid's first row is half a cell from the end.
    const auto grid = roller_ends(roller(), upright(on_grid(.1))).value();
    EXPECT_NEAR(grid.widest_ratio, half_width(length / 2 - .05) / half_width(0), 3e-3);
    EXPECT_NEAR(grid.reach, reach, .3);
}

TEST(RollerEnds, CaptionsAreThoseOfTheEnds) {
    contact::Case c = roller();
    contact::History history = upright(on_grid(.2));
    history.model = "bem";
    history.scales.contact_radius = 1;
    const auto captions = [&] {
        std::string text;
        for (const report::Figure& figure : end_figures(c, {history}))
            text += figure.caption + '\n';
        return text;
    };
    const std::string sharp = "sharp edge's singularity", round = "Rounded ends close";
    c.indenter.chamfer = 0;
    EXPECT_NE(captions().find(sharp), std::string::npos) << captions();
    EXPECT_EQ(captions().find(round), std::string::npos) << captions();
    c.indenter.chamfer = .5;
    EXPECT_EQ(captions().find(sharp), std::string::npos) << captions();
    EXPECT_NE(captions().find(round), std::string::npos) << captions();
}

TEST(RollerEnds, BelongToRollersOnly) {
    contact::Case c = roller();
    EXPECT_FALSE(roller_ends(c, contact::History{}));  // no snapshot
    c.indenter.shape = contact::Case::Shape::cylinder;
    EXPECT_FALSE(roller_ends(c, upright(on_grid(.2))));
}

}  // namespace
}  // namespace tricontact::comparisons::roller_ends_test
