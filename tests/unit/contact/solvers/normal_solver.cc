#include "contact/solvers/normal_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/base/error.h"
#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::normal_solver_test {
namespace {

using contact::NormalControl;
using contact::NormalSolution;
using contact::NormalSolver;
using contact_test::DenseCompliance;

constexpr int n_points = 120;
constexpr double tolerance = 1e-10;
using Kind = NormalControl::Kind;

std::vector<double> bowl(const DenseCompliance& compliance, double curvature) {
    std::vector<double> height;
    const auto& points = compliance.points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = std::hypot(points.x[i] - .1, points.y[i] + .2);
        height.push_back(curvature * r * r);
    }
    return height;
}

/// The conditions that define the one solution, from the definition of the compliance.
void expect_solution(const DenseCompliance& compliance, const std::vector<double>& height,
                     const NormalSolution& s) {
    std::vector<double> u(n_points);
    compliance.normal(s.pressure, u);
    double force = 0;
    for (int i = 0; i < n_points; ++i) {
        const double gap = u[i] + height[i] - s.indentation;
        ASSERT_GE(s.pressure[i], 0);
        ASSERT_GE(gap, -tolerance * s.indentation);
        ASSERT_LE(s.pressure[i] > 0 ? gap : 0, tolerance * s.indentation);
        ASSERT_NEAR(s.displacement[i], u[i], 1e-12 * s.indentation);  // rounding
        force += compliance.points().area[i] * s.pressure[i];
    }
    EXPECT_NEAR(s.force / force, 1, 1e-13);
    EXPECT_LE(s.residual, tolerance);
}

// A single point bears the force without a gap of its own; what lies beside it penetrates.
TEST(NormalSolver, GrowsFromASinglePoint) {
    const DenseCompliance compliance(n_points, 4u);
    const auto height = bowl(compliance, .5);
    for (const auto& control : {NormalControl{Kind::force, .7}, NormalControl{Kind::force, 1e-4}})
        for (std::size_t first = 0; first < n_points; ++first) {
            std::vector<double> start(n_points);
            start[first] = 1;
            const auto s = NormalSolver(compliance, tolerance).solve(height, control, start);
            expect_solution(compliance, height, s);
        }
}

TEST(NormalSolver, SolvesOnPointsOfUnequalAreas) {
    for (const unsigned seed : {1u, 2u, 3u})
        for (const double curvature : {.5, 5., 50.}) {
            const DenseCompliance compliance(n_points, seed);
            const auto height = bowl(compliance, curvature);
            const auto s = NormalSolver(compliance, tolerance).solve(height, {Kind::force, .7});
            expect_solution(compliance, height, s);
            EXPECT_NEAR(s.force, .7, 1e-13);
            EXPECT_LT(s.iterations, 400);
        }
}

TEST(NormalSolver, IndentationControlIsTheInverse) {
    const DenseCompliance compliance(n_points, 4);
    const NormalSolver solver(compliance, tolerance);
    for (const double curvature : {.5, 5.}) {
        const auto height = bowl(compliance, curvature);
        const auto by_force = solver.solve(height, {Kind::force, .7});
        const auto by_depth = solver.solve(height, {Kind::indentation, by_force.indentation});
        expect_solution(compliance, height, by_depth);
        EXPECT_EQ(by_depth.indentation, by_force.indentation);
        // gaps of 1e-10 d times the stiffness of single points
        EXPECT_NEAR(by_depth.force / .7, 1, 1e-8);
        for (int i = 0; i < n_points; ++i)
            EXPECT_NEAR(by_depth.pressure[i], by_force.pressure[i], 1e-7);
    }
}

// Under a pressure of 1 everywhere each point is displaced by what the body reaches into the
// surface: the one solution, A p = d - h and p > 0, without a solver. Found from nothing, where a
// pressure of 1 displaces by the depth, half of it or ten times as much, and from other pressures,
// which no force scales. Gaps of the tolerance times the stiffness of single points: 1e-8.
TEST(NormalSolver, IndentationIsThatOfItsOwnPressures) {
    const DenseCompliance compliance(n_points, 4);
    const NormalSolver solver(compliance, tolerance);
    std::vector<double> unit(n_points, 1.), u(n_points);
    compliance.normal(unit, u);
    const double most = *std::max_element(u.begin(), u.end());
    for (const double depth : {most, 2 * most, .1 * most}) {
        std::vector<double> height;
        for (const double displaced : u) height.push_back(depth - displaced);
        for (const double start : {0., .5, 2., 10.}) {
            const std::vector<double> pressures(start > 0 ? n_points : 0, start);
            const auto s = solver.solve(height, {Kind::indentation, depth}, pressures);
            for (int i = 0; i < n_points; ++i) {
                EXPECT_NEAR(s.pressure[i], 1, 1e-8) << depth / most << ' ' << start;
                EXPECT_NEAR(s.displacement[i], u[i], tolerance * std::max(depth, most));
            }
        }
    }
}

TEST(NormalSolver, WarmStartFindsTheSameFaster) {
    const DenseCompliance compliance(n_points, 5);
    const NormalSolver solver(compliance, tolerance);
    const auto height = bowl(compliance, 5);
    const auto cold = solver.solve(height, {Kind::force, .7});
    const auto same = solver.solve(height, {Kind::force, .7}, cold.pressure);
    EXPECT_LE(same.iterations, 3);
    // from a neighbouring force, and from a start that is wrong everywhere
    const auto near =
        solver.solve(height, {Kind::force, .7}, solver.solve(height, {Kind::force, .6}).pressure);
    EXPECT_LT(near.iterations, cold.iterations);
    std::vector<double> wrong(n_points, 0.);
    for (int i = 0; i < n_points; i += 7) wrong[i] = 1 + i;
    const auto other = solver.solve(height, {Kind::force, .7}, wrong);
    for (int i = 0; i < n_points; ++i) {
        EXPECT_NEAR(near.pressure[i], cold.pressure[i], 1e-7);
        EXPECT_NEAR(other.pressure[i], cold.pressure[i], 1e-7);
    }
}

TEST(NormalSolver, OutsideTheBodyThereIsNoContact) {
    const DenseCompliance compliance(n_points, 6);
    auto height = bowl(compliance, .01);
    for (int i = 0; i < n_points; i += 3) height[i] = std::numeric_limits<double>::infinity();
    std::vector<double> start(n_points, 1.);
    const auto s = NormalSolver(compliance, tolerance).solve(height, {Kind::force, .7}, start);
    double inside = 0;
    for (int i = 0; i < n_points; ++i) {
        EXPECT_EQ(i % 3 == 0 ? s.pressure[i] : 0, 0);
        inside += s.pressure[i];
    }
    EXPECT_GT(inside, 0);
    EXPECT_NEAR(s.force, .7, 1e-13);
}

TEST(NormalSolver, ScalesLikeALinearProblem) {
    // Force and heights times ten: pressures times ten, indentation times ten.
    const DenseCompliance compliance(n_points, 7);
    const NormalSolver solver(compliance, tolerance);
    const auto one = solver.solve(bowl(compliance, 2), {Kind::force, .3});
    const auto ten = solver.solve(bowl(compliance, 20), {Kind::force, 3});
    EXPECT_NEAR(ten.indentation / one.indentation, 10, 1e-7);
    EXPECT_EQ(ten.iterations, one.iterations);
}

TEST(NormalSolver, RefusesToPull) {
    const DenseCompliance compliance(n_points, 8);
    const NormalSolver solver(compliance, tolerance);
    const auto height = bowl(compliance, 1);
    for (const double value : {0., -1., std::nan("")})
        for (const Kind kind : {Kind::force, Kind::indentation})
            EXPECT_THROW(solver.solve(height, {kind, value}), contact::InputError) << value;
}

TEST(NormalSolver, SaysWhenItDoesNotConverge) {
    const DenseCompliance compliance(n_points, 9);
    const NormalSolver impossible(compliance, 0);
    try {
        impossible.solve(bowl(compliance, 5), {Kind::force, .7});
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.rfind("normal contact: ", 0), 0u) << text;
    }
}

}  // namespace
}  // namespace tricontact::normal_solver_test
