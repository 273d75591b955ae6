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

namespace tricontact::mdr_prescribed_path_test {
namespace {

using contact::PrescribedPath;

constexpr double tolerance = 1e-6, mu = .57;

class Sphere {
  public:
    Sphere() {
        case_.indenter.radius = .04;
        case_.substrate = {5.2e6, .5};
        case_.friction_coefficient = mu;
        case_.mdr.springs = 20'000;
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
        case_.load.normal_force = path.hardest_normal().value;
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

// Both rise in proportion from zero, F_T/F_N below mu: nothing slips, dU/dd = F_T/F_N E*/G*.
TEST(MdrPrescribedPath, ObliqueLoadingBelowFrictionNeverSlips) {
    Sphere sphere;
    const auto history = sphere.follow({{0, 0}, {20, 8}}, 10);
    const double expected = .4 * sphere.stiffness_ratio() * sphere.depth(20);
    // In each step the new ring has missed a part of the step's shift. The first one is as large as
    // its depth, which goes with F_N^(2/3) and so with steps^(-2/3). In the limit nothing is
    // missed.
    const auto finer = sphere.follow({{0, 0}, {20, 8}}, 20);
    const auto finest = sphere.follow({{0, 0}, {20, 8}}, 160);
    const double error = last_shift(history) - expected, half = last_shift(finer) - expected,
                 least = last_shift(finest) - expected;
    EXPECT_NEAR(std::log2(half / least) / 3, 2. / 3, .05);
    EXPECT_LT(std::abs(error), .1 * expected);
    const double eighth = std::pow(8, 2. / 3);
    EXPECT_NEAR((eighth * least - half) / (eighth - 1), 0, 1e-3 * expected);
    // Within a step some of the new ring slips; the ring is as wide as the step is long.
    EXPECT_NEAR(finer.steps.back().slip_area / history.steps.back().slip_area, .5, .1);
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
