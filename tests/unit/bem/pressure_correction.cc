#include "contact/solvers/pressure_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "bem/grid_compliance.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::pressure_correction_test {
namespace {

using contact::ContactPoints;
using contact::NormalControl;
using contact::NormalSolver;
using contact::PressedSurface;
using contact::PressureCorrection;

constexpr double radius = 40e-3, force = 21.1, spacing = .2e-3, tolerance = 1e-9;
constexpr int n = 68;  // a window of the contact's box is smaller
constexpr contact::Material rubber{5.2e6, .5};
const double e_star = rubber.young / (1 - rubber.poisson * rubber.poisson);

class PressureCorrections : public testing::Test {
  protected:
    std::vector<double> paraboloid(double x0) const {
        std::vector<double> height;
        const ContactPoints& points = compliance_->points();
        for (std::size_t i = 0; i < points.size(); ++i)
            height.push_back((std::pow(points.x[i] - x0, 2) + std::pow(points.y[i], 2)) /
                             (2 * radius));
        return height;
    }
    std::vector<double> pressed(double x0) const {
        return NormalSolver(*compliance_, tolerance)
            .solve(paraboloid(x0), {NormalControl::Kind::force, force}, {})
            .pressure;
    }

    const double first_ = -(n - 1) / 2. * spacing;
    const std::unique_ptr<bem::GridCompliance> compliance_ = bem::half_space_compliance(
        {std::nullopt, rubber}, ContactPoints::grid(n, n, {first_, first_}, {spacing, spacing}), 1);
    const PressureCorrection correction_{*compliance_, tolerance};
};

// The pressures under a sphere that has rolled by a part of a cell: points leave behind and enter
// ahead. Beside those of the other method from nothing, which a tolerance of 1e-9 in the gap lets
// differ by 1e-6; the force is exact, and nothing pulls or penetrates.
TEST_F(PressureCorrections, FollowsASphereThatRolls) {
    const std::vector<double> start = pressed(0);
    for (const double moved : {.02, .06}) {
        const auto height = paraboloid(moved * spacing);
        const auto reference = pressed(moved * spacing);
        PressedSurface corrected;
        ASSERT_TRUE(correction_.correct(height, force, start, corrected)) << moved;
        const double highest = *std::ranges::max_element(reference);
        double carried = 0, worst = 0;
        for (std::size_t i = 0; i < height.size(); ++i) {
            worst = std::max(worst, std::abs(corrected.pressure[i] - reference[i]));
            carried += corrected.pressure[i] * spacing * spacing;
            EXPECT_GE(corrected.pressure[i], 0);
        }
        EXPECT_LT(worst / highest, 1e-6) << moved;
        EXPECT_NEAR(carried / force, 1, 1e-8);
    }
}

// p0 = (6 F E*^2/(pi^3 R^2))^(1/3) (Johnson 1985, eq. 4.24), from the pressures of a force 1 %
// less; half a cell beside the centre, 19 cells in the radius.
TEST_F(PressureCorrections, IsHertzianUnderAnotherForce) {
    const auto less = NormalSolver(*compliance_, tolerance)
                          .solve(paraboloid(0), {NormalControl::Kind::force, .99 * force}, {});
    PressedSurface corrected;
    ASSERT_TRUE(correction_.correct(paraboloid(0), force, less.pressure, corrected));
    const double p0 =
        std::cbrt(6 * force * e_star * e_star / (std::pow(std::numbers::pi, 3) * radius * radius));
    EXPECT_NEAR(*std::ranges::max_element(corrected.pressure) / p0, 1, 3e-3);
}

TEST_F(PressureCorrections, LeavesAnotherContactToOthers) {
    const std::vector<double> start = pressed(0);
    PressedSurface corrected;
    EXPECT_FALSE(correction_.correct(paraboloid(3 * spacing), force, start, corrected));
    auto blunt = paraboloid(0);
    for (double& height : blunt) height *= 1.2;
    EXPECT_FALSE(correction_.correct(blunt, force, start, corrected));
}

}  // namespace
}  // namespace tricontact::pressure_correction_test
