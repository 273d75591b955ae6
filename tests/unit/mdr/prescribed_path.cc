// Normal and tangential forces that change in turn, against closed forms of Mindlin and Deresiewicz
// (1953, J. Appl. Mech. 20, 327), which the method of dimensionality reduction has exactly (Jaeger
// 1995, Popov and Hess 2015): whatever slips has the shift mu E*/G* times a difference of depths
// and the force mu times the difference of the normal forces at these depths. Tolerances: the sum
// over 20 000 springs is that of the integral to their spacing squared, 1e-7.

#include "contact/prescribed_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/case.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"

namespace tricontact::mdr_prescribed_path_test {
namespace {

using contact::PrescribedPath;

constexpr double tolerance = 1e-6, mu = .57;

class Sphere {
  public:
    Sphere() {
        case_.indenter.radius = .04;
        case_.substrate = {5.2e6, .5};
        case_.friction.coefficient = mu;
        case_.of<mdr::Settings>().springs = 20'000;
    }
    /// Of the rows {F_N, F_T}, both in N.
    contact::History follow(const std::vector<std::array<double, 2>>& loads, int steps = 1) {
        PrescribedPath path;
        for (const auto& [normal, tangential] : loads) {
            PrescribedPath::Row row;
            row.normal.value = normal;
            row.tangential[0].value = tangential;
            row.steps = steps;
            path.rows.push_back(row);
        }
        return follow(path);
    }
    /// From rest to a depth and a shift [m], both in proportion, in one step.
    contact::History move(double depth, double shift) {
        PrescribedPath path;
        for (const double share : {0., 1.}) {
            PrescribedPath::Row row;
            row.normal = {contact::NormalControl::Kind::indentation, share * depth};
            row.tangential[0] = {contact::TangentialControl::Kind::shift, share * shift};
            path.rows.push_back(row);
        }
        return follow(path);
    }
    contact::History follow(const PrescribedPath& path) {
        const auto hardest = path.hardest_normal();
        (hardest.kind == contact::NormalControl::Kind::force ? case_.load.normal_force
                                                             : case_.load.indentation) =
            hardest.value;
        case_.load.tangential_force = 0;
        case_.load.press_steps = 1;
        case_.prescribed_path = path;
        return contact::run(case_, *mdr::make_model(case_));
    }
    /// Hertz' d [m] under a force [N].
    double depth(double force) const {
        return std::cbrt(std::pow(.75 * force / case_.materials().effective_modulus(), 2) /
                         case_.indenter.radius);
    }
    double stiffness_ratio() const {
        return case_.materials().effective_modulus() / case_.materials().effective_shear_modulus();
    }
    /// mu E*/G* (d(F) - d(F - F_T/mu)) [m]: the shift by F_T under F.
    double shift(double normal, double tangential) const {
        return mu * stiffness_ratio() * (depth(normal) - depth(normal - tangential / mu));
    }

  private:
    contact::Case case_;
};

double last_shift(const contact::History& history) {
    return history.steps.back().shift[0];
}

// Both rise in proportion from zero, F_T/F_N below mu: nothing slips, dU/dd = F_T/F_N E*/G*. New
// springs are carried along from where they are met on: one step is as exact as many.
TEST(MdrPrescribedPath, ObliqueLoadingBelowFrictionNeverSlips) {
    Sphere sphere;
    const double expected = .4 * sphere.stiffness_ratio() * sphere.depth(20);
    for (const int steps : {1, 10}) {
        const auto history = sphere.follow({{0, 0}, {20, 8}}, steps);
        EXPECT_NEAR(last_shift(history), expected, tolerance * expected) << steps;
        EXPECT_EQ(history.steps.back().slip_area, 0) << steps;
        EXPECT_EQ(history.steps.back().dissipation, 0) << steps;
    }
}

// The same from an F_N on, with a force that has acted before: the shifts of both parts add up.
TEST(MdrPrescribedPath, ObliqueFurtherLoadingBelowFrictionDoesNotSlipFurther) {
    Sphere sphere;
    const double expected =
        sphere.shift(10, 4) + .4 * sphere.stiffness_ratio() * (sphere.depth(16) - sphere.depth(10));
    for (const int steps : {1, 6}) {
        const auto history = sphere.follow({{10, 0}, {10, 4}, {16, 6.4}}, steps);
        EXPECT_NEAR(last_shift(history), expected, tolerance * expected) << steps;
    }
}

// By shift and depth instead of forces: the force that the shift takes.
TEST(MdrPrescribedPath, ObliqueMotionBelowFrictionTakesItsForceInOneStep) {
    Sphere sphere;
    const double depth = sphere.depth(20), shift = .4 * sphere.stiffness_ratio() * depth;
    const auto history = sphere.move(depth, shift);
    EXPECT_NEAR(history.steps.back().normal_force, 20, 20 * tolerance);
    EXPECT_NEAR(history.steps.back().tangential_force[0], 8, 8 * tolerance);
}

/// What moves the sphere along while it rolls to `offset` [m] under F_N = 20 N, F_T = 5 N.
double shift_by_rolling(double offset, int steps) {
    PrescribedPath::Row row;
    row.normal.value = 20;
    row.tangential[0].value = 5;
    PrescribedPath path{{row, row}};
    path.rows[1].offset = {offset, 0};
    path.rows[1].steps = steps;
    const auto history = Sphere().follow(path);
    return last_shift(history) - history.steps[history.steps.size() - 1 - steps].shift[0];
}

// A spring at the front is carried along from where it is met on: an error of the second order.
TEST(MdrPrescribedPath, StepsOfRollingAreOfTheSecondOrder) {
    const double coarse = shift_by_rolling(1e-3, 8), fine = shift_by_rolling(1e-3, 16),
                 finest = shift_by_rolling(1e-3, 32);
    EXPECT_GT(std::log2((fine - coarse) / (finest - fine)), 1.5);
}

// From F_N alone on, F_T rises more than mu F_N does: as if F_N had been there before.
TEST(MdrPrescribedPath, SteepObliqueLoadingForgetsItsPath) {
    Sphere sphere;
    const auto history = sphere.follow({{10, 0}, {14, 5}}, 40);
    EXPECT_NEAR(last_shift(history), sphere.shift(14, 5), tolerance * sphere.shift(14, 5));
}

// F_N rises under a constant F_T: nothing slips, nothing moves.
TEST(MdrPrescribedPath, PressingMoreUnderTangentialForceMovesNothing) {
    Sphere sphere;
    const auto history = sphere.follow({{10, 0}, {10, 4}, {16, 4}}, 5);
    EXPECT_NEAR(last_shift(history), sphere.shift(10, 4), tolerance * sphere.shift(10, 4));
}

// And F_T on top of it slips in the new ring alone, until that is used up at 4 + mu (16 - 10) N.
TEST(MdrPrescribedPath, FurtherForceSlipsInTheNewRingFirst) {
    Sphere sphere;
    const auto history = sphere.follow({{10, 0}, {10, 4}, {16, 4}, {16, 6}}, 1);
    const double expected = sphere.shift(10, 4) + sphere.shift(16, 2);
    EXPECT_NEAR(last_shift(history), expected, tolerance * expected);
    // Beyond it the history is forgotten.
    const auto beyond = sphere.follow({{10, 0}, {10, 4}, {16, 4}, {16, 8}}, 1);
    EXPECT_NEAR(last_shift(beyond), sphere.shift(16, 8), tolerance * sphere.shift(16, 8));
}

// Back and forth under a constant F_N: Masing's rule, twice the first curve at half the change.
TEST(MdrPrescribedPath, TurnsBackOnTwiceTheFirstCurve) {
    Sphere sphere;
    const auto history = sphere.follow({{20, 0}, {20, 8}, {20, -3}, {20, 5}}, 1);
    const double back = sphere.shift(20, 8) - 2 * sphere.shift(20, 5.5);
    EXPECT_NEAR(history.steps[2].shift[0], back, tolerance * sphere.shift(20, 8));
    EXPECT_NEAR(last_shift(history), back + 2 * sphere.shift(20, 4),
                tolerance * sphere.shift(20, 8));
}

// F_N falls under a constant F_T: it slips as on unloading, to the first curve of the F_N reached.
TEST(MdrPrescribedPath, UnloadingSlipsOnward) {
    Sphere sphere;
    const auto history = sphere.follow({{20, 0}, {20, 6}, {13, 6}}, 1);
    EXPECT_NEAR(last_shift(history), sphere.shift(13, 6), tolerance * sphere.shift(13, 6));
}

}  // namespace
}  // namespace tricontact::mdr_prescribed_path_test
