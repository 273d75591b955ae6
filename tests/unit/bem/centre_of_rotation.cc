// One rule for the point that an indenter twists about: for bodies, height maps, paths and files of
// the program CONTACT (docs/how-to/path.md). Symmetry, closed forms, and CONTACT's own numbers.

#include "contact/solvers/centre_of_rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/run.h"
#include "theory/torsion.h"

namespace tricontact::bem::centre_of_rotation_test {
namespace {

using contact::Case;
using contact::CentreOfRotation;
using contact::NormalControl;
using contact::PrescribedPath;
using contact::StepRecord;
using contact::TangentialControl;
using contact::Vector2;
using Frame = CentreOfRotation::Frame;

constexpr double radius = .05, cell = 1e-4, depth = 1e-5;

/// Two steel bodies pressed to `depth`, whose coupling is 0.
Case pressed_steel() {
    Case c;
    c.indenter.radius = radius;
    c.indenter.material = c.substrate = contact::Material{210e9, .28};
    c.friction.coefficient = .3;
    c.load.indentation = depth;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().spacing = cell;
    c.prescribed_path.emplace();
    for (const double d : {0., depth, depth}) {
        PrescribedPath::Row row;
        row.normal = {NormalControl::Kind::indentation, d};
        for (auto& control : row.tangential) control.kind = TangentialControl::Kind::shift;
        c.prescribed_path->rows.push_back(row);
    }
    return c;
}

PrescribedPath::Row& last_row(Case& c) {
    return c.prescribed_path->rows.back();
}

StepRecord last_step(const Case& c) {
    return contact::run(c, *make_model(c, 1)).steps.back();
}

/// The same ball as a map of n_x by n_y nodes whose lowest is (i, j).
Case mapped(int n_x, int n_y, int i, int j) {
    Case c = pressed_steel();
    auto map = std::make_shared<contact::HeightMap>(contact::HeightMap{n_x, n_y, {cell, cell}, {}});
    for (int row = 0; row < n_y; ++row)
        for (int k = 0; k < n_x; ++k)
            map->height.push_back(cell * cell * ((k - i) * (k - i) + (row - j) * (row - j)) /
                                  (2 * radius));
    c.indenter.shape = Case::Shape::height_map;
    c.indenter.height_map = std::move(map);
    return c;
}

// Twist alone about the lowest point of a ball has no force by symmetry, and what is pressed does
// not depend on how much of the body was measured beside it.
TEST(CentreOfRotation, DoesNotDependOnTheWindowOfAMap) {
    Case ball = pressed_steel();
    last_row(ball).rotation = 1e-3;
    last_row(ball).tangential[0].value = 5e-7;
    const StepRecord expected = last_step(ball);
    for (const auto& [n_x, n_y, i, j] :
         std::vector<std::array<int, 4>>{{25, 25, 12, 12}, {31, 25, 12, 12}, {25, 34, 14, 20}}) {
        SCOPED_TRACE(n_x * 100 + n_y);
        Case c = mapped(n_x, n_y, i, j);
        EXPECT_NEAR(c.make_indenter()->lowest_point()[0], (i - n_x / 2) * cell, 1e-12);
        last_row(c).rotation = 1e-3;
        const StepRecord twisted = last_step(c);
        const double limit = c.friction_coefficient() * twisted.normal_force;
        EXPECT_NEAR(twisted.tangential_force[0] / limit, 0, 1e-6);
        EXPECT_NEAR(twisted.tangential_force[1] / limit, 0, 1e-6);
        last_row(c).tangential[0].value = 5e-7;
        const StepRecord both = last_step(c);
        EXPECT_NEAR(both.tangential_force[0] / expected.tangential_force[0], 1, 1e-6);
        EXPECT_NEAR(both.torque / expected.torque, 1, 1e-6);
    }
}

TEST(CentreOfRotation, OfEquallyLowNodesIsTheirMean) {
    contact::HeightMap map{4, 3, {1e-3, 2e-3}, {5, 1, 1, 5, 4, 1, 1, 4, 5, 3, 3, 5}};
    const Vector2 lowest = contact::MappedIndenter(map).lowest_point();
    EXPECT_NEAR(lowest[0], -.5e-3, 1e-15);  // from node 2 of 4
    EXPECT_NEAR(lowest[1], -1e-3, 1e-15);   // from node 1 of 3
}

// All slips: about the lowest point the torque is 3 pi/16 mu F_N a (Hertz' pressure), about a far
// point all friction acts across the arm D to it, M = mu F_N D (1 + O(a^2/D^2)).
TEST(CentreOfRotation, SlidesAsTheClosedForms) {
    Case c = pressed_steel();
    last_row(c).rotation = 1;
    const double a = half_space_scales(c).contact_radius;
    const StepRecord spun = last_step(c);
    const double limit = c.friction_coefficient() * spun.normal_force;
    // Seven cells in the radius: the edge costs a percent.
    EXPECT_NEAR(spun.torque / (limit * a), theory::torque_ratio(0), .01 * theory::torque_ratio(0));
    const double arm = 100 * a;
    for (const Frame frame : {Frame::indenter, Frame::substrate}) {
        c.prescribed_path->centre = {frame, {-arm, 0}};
        last_row(c).rotation = 1e-2;
        const StepRecord swept = last_step(c);
        EXPECT_NEAR(swept.tangential_force[1] / limit, 1, 1e-4);
        EXPECT_NEAR(swept.torque / (limit * arm), 1, 1e-4);
    }
}

// A twist about P with the shift U of P is one about any other point with the shift of that point;
// the work of the loads is the same, so that the torque changes by the arm times the force. The
// body moves on the way, and with it what moves with it.
TEST(CentreOfRotation, TwistsAboutAnyPointAlike) {
    const Vector2 moved{3e-4, -2e-4}, point{4e-4, 7e-4};
    Case c = pressed_steel();
    last_row(c).offset = moved;
    last_row(c).rotation = 8e-4;
    last_row(c).tangential[0].value = 4e-7;
    last_row(c).tangential[1].value = -2e-7;
    const StepRecord own = last_step(c);
    const Vector2 arm{point[0] - moved[0], point[1] - moved[1]};
    last_row(c).tangential[0].value -= 8e-4 * arm[1];
    last_row(c).tangential[1].value += 8e-4 * arm[0];
    const auto expect_the_same = [&](const CentreOfRotation& centre) {
        c.prescribed_path->centre = centre;
        const StepRecord other = last_step(c);
        for (const int d : {0, 1})
            EXPECT_NEAR(other.tangential_force[d] / own.tangential_force[d], 1, 1e-9);
        EXPECT_NEAR(other.dissipation / own.dissipation, 1, 1e-9);
        const double turned =
            own.torque - arm[0] * own.tangential_force[1] + arm[1] * own.tangential_force[0];
        EXPECT_NEAR(other.torque / turned, 1, 1e-9);
    };
    expect_the_same({Frame::substrate, point});
    expect_the_same({Frame::indenter, arm});
}

}  // namespace
}  // namespace tricontact::bem::centre_of_rotation_test
