#include <gtest/gtest.h>

#include "comparisons/quantities/surface_fields.h"
#include "report/figure.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::fields_test {
namespace {

const auto coulomb_law = contact::Friction{.coefficient = 1}.law();
const contact::FrictionLaw& coulomb = *coulomb_law;
const auto half_law = contact::Friction{.coefficient = .5}.law();
const contact::FrictionLaw& half = *half_law;

using contact::ContactState;
using synthetic::Options;

/// Five points on a line, unit spacing, centre in the middle, p = 1 everywhere.
contact::Snapshot row(double phase, const std::vector<double>& p, const std::vector<double>& tau) {
    contact::Snapshot snapshot;
    snapshot.phase = phase;
    contact::Surface& s = snapshot.surface;
    s.n_x = static_cast<int>(p.size());
    s.n_y = 1;
    s.first = {-2, 0};
    s.spacing = {1, 1};
    s.normal_traction = s.friction_bound = p;
    s.tangential_traction_x = tau;
    s.tangential_traction_y.assign(p.size(), 0);
    s.contact_state.assign(p.size(), ContactState::stick);
    return snapshot;
}

TEST(Zones, WhatAPointDoesDuringThePeriodDecides) {
    contact::History history;
    // Long ago everything slipped; only the last period counts.
    history.snapshots.push_back(row(0, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}));
    history.snapshots.push_back(row(1, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}));
    history.snapshots.push_back(row(1.25, {0, 0.5, 1, 2, 2}, {0, 0.5, 0.5, 0.5, 0}));
    history.snapshots.push_back(row(1.75, {2, 2, 1, 1, 0}, {0, 0.5, 0.5, 0.5, 0}));
    history.snapshots.push_back(row(2, {1, 1, 1, 1, 0}, {0, 0.5, 0.5, 0.5, 0}));
    const std::vector<Zone> expected{Zone::zero, Zone::slip, Zone::stick, Zone::stick, Zone::open};
    EXPECT_EQ(zones(history, coulomb), expected);
}

TEST(Zones, SpringsDecideInLineLayout) {
    contact::History history;
    contact::Snapshot snapshot = row(0, {1, 1, 1, 1, 1}, {1, 1, 1, 1, 1});
    snapshot.surface.layout = contact::Surface::Layout::line;
    snapshot.surface.normal_line_load = {0, 1, 1, 2, 0};
    snapshot.surface.tangential_line_load = {0, 0.5, 0.4, -0.5, 0};
    history.snapshots.push_back(snapshot);
    // mu = 1/2: the second spring carries its bound.
    const std::vector<Zone> expected{Zone::open, Zone::slip, Zone::stick, Zone::stick, Zone::open};
    EXPECT_EQ(zones(history, half), expected);
}

TEST(Zones, StickRadiusOfCattaneoAndMindlin) {
    const Options options{.f = 0.488, .rolling = false, .n_x = 201, .n_y = 201};  // c = 0.8 a
    contact::History history = synthetic::loaded_history("bem", options);
    synthetic::add_snapshots(history, options, false);
    const auto parts = stretches(centre_line(history, coulomb, Axis::x));
    ASSERT_EQ(parts.size(), 5u);  // open, slip, stick, slip, open
    EXPECT_EQ(parts[2].zone, Zone::stick);
    // Ends lie between two grid points, which are 0.016 a apart.
    EXPECT_NEAR(parts[2].end, 0.8, 0.017);
    EXPECT_NEAR(parts[2].begin, -0.8, 0.017);
    EXPECT_NEAR(parts[1].begin, -1, 0.017);
}

TEST(CentreLine, IsNormalisedByTheModelsOwnScales) {
    const Options options{.f = 0.488, .rolling = false, .n_x = 101, .n_y = 101};
    contact::History history = synthetic::loaded_history("bem", options);
    synthetic::add_snapshots(history, options, false);
    const CentreLine line = centre_line(history, coulomb, Axis::y);
    for (std::size_t i = 0; i < line.position.size(); ++i) {
        const double rho = std::abs(line.position[i]);
        // An odd grid has a row through the centre: exact but for rounding.
        EXPECT_NEAR(line.traction[i], theory::cattaneo_mindlin_traction(rho, 0.488), 1e-12);
    }
}

TEST(CentreLine, EvenGridsAverageTheMiddleRows) {
    contact::History history;
    history.scales = {.normal_force = 1,
                      .contact_radius = 2,
                      .indentation = 1,
                      .peak_pressure = 4,
                      .unit_shift = 1};
    contact::Snapshot snapshot = row(0, {1, 1, 3, 3}, {0.1, 0.2, 0.3, 0.4});
    snapshot.surface.n_x = snapshot.surface.n_y = 2;
    snapshot.surface.first = {-0.5, -0.5};
    history.snapshots.push_back(snapshot);
    const CentreLine line = centre_line(history, half, Axis::x);
    ASSERT_EQ(line.position.size(), 2u);
    EXPECT_DOUBLE_EQ(line.position[1], 0.25);
    EXPECT_DOUBLE_EQ(line.traction[0], (0.1 + 0.3) / 2 / (0.5 * 4));
    EXPECT_DOUBLE_EQ(line.traction[1], (0.2 + 0.4) / 2 / (0.5 * 4));
}

TEST(Snapshots, LastUprightAndByPhase) {
    contact::History history;
    EXPECT_EQ(last_upright(history), nullptr);
    EXPECT_TRUE(zones(history, coulomb).empty());
    EXPECT_TRUE(centre_line(history, coulomb, Axis::x).position.empty());
    for (const double phase : {0.0, 0.25, 1.0, 1.25})
        history.snapshots.push_back(row(phase, {1}, {0}));
    EXPECT_EQ(last_upright(history), &history.snapshots[2]);
    EXPECT_EQ(snapshot_at(history, 0.25), &history.snapshots[1]);
    EXPECT_EQ(snapshot_at(history, 2.75), nullptr);
}

TEST(Thinned, KeepsBothEndsAndTheLimit) {
    EXPECT_TRUE(report::thinned(0, 10).empty());
    EXPECT_EQ(report::thinned(4, 10), (std::vector<std::size_t>{0, 1, 2, 3}));
    const auto many = report::thinned(100001, 1000);
    EXPECT_LE(many.size(), 1001u);
    EXPECT_EQ(many.front(), 0u);
    EXPECT_EQ(many.back(), 100000u);
}

}  // namespace
}  // namespace tricontact::comparisons::fields_test
