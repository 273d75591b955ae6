#include "contact/solvers/tangential_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "contact/base/error.h"
#include "contact/solvers/projected_gradient.h"
#include "tests/unit/contact/dense_compliance.h"

namespace tricontact::tangential_solver_test {
namespace {

using contact::TangentialControl;
using contact::TangentialField;
using contact::TangentialProblem;
using contact::TangentialSolution;
using contact::TangentialSolver;
using contact_test::DenseCompliance;
using Kind = TangentialControl::Kind;

constexpr int n_points = 60;
constexpr double tolerance = 1e-10;

/// Bounds like a pressure, some points open, and a displacement left over from earlier steps.
struct Setting {
    DenseCompliance compliance;
    std::vector<double> bound;
    TangentialField previous{n_points};
    double total_bound = 0, mean_bound = 0;

    explicit Setting(unsigned seed, double history = .1) : compliance(n_points, seed) {
        const auto& points = compliance.points();
        double area = 0;
        for (int i = 0; i < n_points; ++i) {
            const double r2 = points.x[i] * points.x[i] + points.y[i] * points.y[i];
            bound.push_back(r2 < 1 ? .6 * std::sqrt(1 - r2) : 0);
            previous.x[i] = history * std::sin(7. * i);
            previous.y[i] = history * std::cos(3. * i);
            total_bound += points.area[i] * bound[i];
            if (bound[i] > 0) area += points.area[i];
        }
        mean_bound = total_bound / area;
    }
    TangentialProblem problem(std::array<TangentialControl, 2> control) const {
        return {bound, previous, control, contact_compliance};
    }
    TangentialSolution solve(std::array<TangentialControl, 2> control,
                             TangentialSolution start = {}) const {
        TangentialSolver(compliance, tolerance).solve(problem(control), start);
        return start;
    }
    static constexpr double contact_compliance = 5;
};

std::array<TangentialControl, 2> forces(double x, double y) {
    return {{{Kind::force, x}, {Kind::force, y}}};
}

/// The conditions that define the one solution: friction bound, Coulomb's law, what is prescribed.
/// `allowed`: slip where points stick, over the contact's compliance and mean bound, and angle
/// between traction and slip [-].
void expect_solution(const Setting& setting, std::array<TangentialControl, 2> control,
                     const TangentialSolution& s, double allowed) {
    TangentialField u(n_points);
    setting.compliance.tangential(s.traction, u);
    const double length = Setting::contact_compliance * setting.mean_bound;
    double force[2] = {0, 0};
    for (int i = 0; i < n_points; ++i) {
        const double t = std::hypot(s.traction.x[i], s.traction.y[i]);
        ASSERT_LE(t, setting.bound[i] * (1 + 1e-14));
        const double slip_x = s.shift_increment[0] + setting.previous.x[i] - u.x[i];
        const double slip_y = s.shift_increment[1] + setting.previous.y[i] - u.y[i];
        force[0] += setting.compliance.points().area[i] * s.traction.x[i];
        force[1] += setting.compliance.points().area[i] * s.traction.y[i];
        if (setting.bound[i] == 0) continue;
        const double most = 3 * allowed * (length + std::hypot(slip_x, slip_y));
        // slip may have a part along t only where t is at the bound, and no part against it
        const double along = (slip_x * s.traction.x[i] + slip_y * s.traction.y[i]) / t;
        const double across = (slip_x * s.traction.y[i] - slip_y * s.traction.x[i]) / t;
        ASSERT_LE(std::abs(across), most) << i;
        ASSERT_GE(along, -most) << i;
        const bool sticks = t < setting.bound[i] * (1 - 1e-9);
        ASSERT_LE(sticks ? along : 0, most) << i;
    }
    for (int d = 0; d < 2; ++d) {
        if (control[d].kind == Kind::force) {
            EXPECT_NEAR(force[d], control[d].value, 1e-10 * setting.total_bound);
        } else {
            EXPECT_EQ(s.shift_increment[d], control[d].value);
        }
    }
}

int n_slipping(const Setting& setting, const TangentialSolution& s) {
    int count = 0;
    for (int i = 0; i < n_points; ++i)
        count += setting.bound[i] > 0 &&
                 std::hypot(s.traction.x[i], s.traction.y[i]) > setting.bound[i] * (1 - 1e-9);
    return count;
}

TEST(TangentialSolver, ForcesInBothDirections) {
    for (const unsigned seed : {1u, 2u, 3u, 4u})
        for (const double part : {.1, .5, .9, .999, .9999999})
            for (const double angle : {0., .7, 2.5}) {
                const Setting setting(seed);
                const double force = part * setting.total_bound;
                const auto control = forces(force * std::cos(angle), force * std::sin(angle));
                const auto s = setting.solve(control);
                SCOPED_TRACE(testing::Message() << seed << ' ' << part << ' ' << angle);
                expect_solution(setting, control, s, tolerance);
                EXPECT_LE(s.residual, tolerance);
                EXPECT_LE(s.force_residual, 1e-10);
            }
}

TEST(TangentialSolver, ShiftControlIsTheInverse) {
    const Setting setting(5);
    const auto control = forces(.5 * setting.total_bound, -.2 * setting.total_bound);
    const auto by_force = setting.solve(control);
    const int slipping = n_slipping(setting, by_force);
    EXPECT_GT(slipping, 3);
    EXPECT_LT(slipping, n_points / 2);
    const auto& shift = by_force.shift_increment;
    for (const Kind kind_x : {Kind::force, Kind::shift})
        for (const Kind kind_y : {Kind::force, Kind::shift}) {
            auto mixed = control;
            if (kind_x == Kind::shift) mixed[0] = {Kind::shift, shift[0]};
            if (kind_y == Kind::shift) mixed[1] = {Kind::shift, shift[1]};
            const auto s = setting.solve(mixed);
            expect_solution(setting, mixed, s, tolerance);
            for (int i = 0; i < n_points; ++i) {
                // tolerance on slips, times the stiffness of single points (condition ~ 1e2)
                EXPECT_NEAR(s.traction.x[i], by_force.traction.x[i], 1e-7);
                EXPECT_NEAR(s.traction.y[i], by_force.traction.y[i], 1e-7);
            }
        }
}

TEST(TangentialSolver, FullSlidingUnderALargeShift) {
    const Setting setting(6);
    const std::array<TangentialControl, 2> control{{{Kind::shift, 300}, {Kind::shift, 400}}};
    const auto s = setting.solve(control);
    for (int i = 0; i < n_points; ++i) {
        // directions of slip deviate by displacements over the shift: 3/500
        EXPECT_NEAR(s.traction.x[i], .6 * setting.bound[i], 1e-2 * setting.bound[i]);
        EXPECT_NEAR(s.traction.y[i], .8 * setting.bound[i], 1e-2 * setting.bound[i]);
    }
    expect_solution(setting, control, s, tolerance);
}

// Everything slides in one direction, then is dragged in another: the zones of the start cannot
// carry a change of force in the old direction.
TEST(TangentialSolver, SlidingTurnsRound) {
    for (const unsigned seed : {6u, 7u, 8u}) {
        Setting setting(seed, 0);
        auto step = [&](std::array<TangentialControl, 2> control, TangentialSolution& s) {
            s = setting.solve(control, s);
            expect_solution(setting, control, s, tolerance);
            setting.previous = s.displacement;
        };
        TangentialSolution s;
        step({{{Kind::shift, -100}, {Kind::force, 0}}}, s);
        step({{{Kind::force, 0}, {Kind::shift, -100}}}, s);
        EXPECT_LT(std::abs(s.shift_increment[0]), 10);
        step({{{Kind::shift, 100}, {Kind::shift, 30}}}, s);
        step(forces(-.999999 * setting.total_bound, 0), s);
        step(forces(0, .999999 * setting.total_bound), s);
        step(forces(0, 0), s);
    }
}

TEST(TangentialSolver, NothingHappensWithoutLoadOrHistory) {
    const Setting setting(7, 0);
    const auto s = setting.solve(forces(0, 0));
    EXPECT_EQ(s.shift_increment, (contact::Vector2{0, 0}));
    EXPECT_EQ(s.traction.x, std::vector<double>(n_points, 0.));
    EXPECT_EQ(s.traction.y, std::vector<double>(n_points, 0.));
}

TEST(TangentialSolver, ZeroForceWithHistoryBalancesItself) {
    const Setting setting(8);
    const auto s = setting.solve(forces(0, 0));
    expect_solution(setting, forces(0, 0), s, tolerance);
    EXPECT_GT(*std::max_element(s.traction.x.begin(), s.traction.x.end()), .1);
}

TEST(TangentialSolver, StartDoesNotMatter) {
    const Setting setting(9);
    const auto control = forces(.6 * setting.total_bound, 0);
    const auto cold = setting.solve(control);
    TangentialSolution random;
    random.traction = TangentialField(n_points);
    for (int i = 0; i < n_points; ++i) {
        random.traction.x[i] = std::cos(11. * i);  // beyond the bound, and on open points
        random.traction.y[i] = std::sin(13. * i);
    }
    for (const auto& start : {cold, random, setting.solve(forces(0, .9 * setting.total_bound))}) {
        const auto s = setting.solve(control, start);
        expect_solution(setting, control, s, tolerance);
        for (int i = 0; i < n_points; ++i) EXPECT_NEAR(s.traction.x[i], cold.traction.x[i], 1e-7);
    }
    EXPECT_LT(setting.solve(control, cold).iterations, cold.iterations / 2);
}

// As after a step that lowered the bounds by less than the tolerance: the start solves the problem
// but for its slipping points, which are a little below the bound. Left there they would count as
// stuck.
TEST(TangentialSolver, AStartThatSlipsBelowTheBoundIsPutOnIt) {
    constexpr double coarse = 1e-7, below = 1e-8;
    const Setting setting(9);
    const auto exact = setting.solve(forces(.6 * setting.total_bound, 0));
    ASSERT_GT(n_slipping(setting, exact), 3);
    auto start = exact;
    auto at_bound = [&](const TangentialSolution& s, int i, double closeness) {
        return setting.bound[i] > 0 &&
               std::hypot(s.traction.x[i], s.traction.y[i]) >= setting.bound[i] * (1 - closeness);
    };
    for (int i = 0; i < n_points; ++i)
        if (at_bound(exact, i, 1e-9)) {
            start.traction.x[i] *= 1 - below;
            start.traction.y[i] *= 1 - below;
        }
    // The shift prescribed, so that the start may be taken as it is.
    const std::array<TangentialControl, 2> control{
        {{Kind::shift, exact.shift_increment[0]}, {Kind::shift, exact.shift_increment[1]}}};
    TangentialSolver(setting.compliance, coarse).solve(setting.problem(control), start);
    EXPECT_LE(start.residual, coarse);
    for (int i = 0; i < n_points; ++i)
        if (at_bound(exact, i, 1e-9)) {
            EXPECT_TRUE(at_bound(start, i, 1e-11)) << i;
        }
}

TEST(TangentialSolver, ProjectedGradientsFindTheSame) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Setting setting(seed);
        std::vector<std::size_t> active;
        for (int i = 0; i < n_points; ++i)
            if (setting.bound[i] > 0) active.push_back(i);
        auto mixed = forces(.4 * setting.total_bound, 0);
        mixed[1] = {Kind::shift, .3};
        for (const auto& control :
             {forces(.7 * setting.total_bound, .2 * setting.total_bound), forces(0, 0), mixed}) {
            const auto newton = setting.solve(control);
            TangentialSolution gradient;
            gradient.traction = TangentialField(n_points);
            contact::projected_gradient(setting.compliance, active,
                                        *make_active_operator(setting.compliance, active),
                                        setting.problem(control), 4000, gradient);
            EXPECT_EQ(gradient.iterations, 4000);
            expect_solution(setting, control, gradient, 1e-7);  // linear convergence
            for (int d = 0; d < 2; ++d)
                EXPECT_NEAR(gradient.shift_increment[d], newton.shift_increment[d], 1e-6);
            for (int i = 0; i < n_points; ++i) {
                EXPECT_NEAR(gradient.traction.x[i], newton.traction.x[i], 1e-6);
                EXPECT_NEAR(gradient.traction.y[i], newton.traction.y[i], 1e-6);
            }
        }
    }
}

TEST(TangentialSolver, RefusesAForceThatFrictionCannotCarry) {
    const Setting setting(10);
    for (const double part : {1., 1.5}) {
        const double force = part * setting.total_bound;
        EXPECT_THROW(setting.solve(forces(.6 * force, .8 * force)), contact::InputError) << part;
        EXPECT_THROW(setting.solve(forces(0, -force)), contact::InputError) << part;
    }
    // in one direction alone it may come close to the limit while the other slides freely
    auto sliding = forces(0, 0);
    sliding[0] = {Kind::shift, 100};
    EXPECT_NO_THROW(setting.solve(sliding));
}

TEST(TangentialSolver, SaysWhenItDoesNotConverge) {
    const Setting setting(11);
    TangentialSolution s;
    try {
        TangentialSolver(setting.compliance, 0)
            .solve(setting.problem(forces(.5 * setting.total_bound, 0)), s);
        FAIL() << "no error";
    } catch (const contact::NotConverged& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("tolerance 0.0e+00"), std::string::npos) << text;
        EXPECT_NE(text.find("points in contact"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace tricontact::tangential_solver_test
