// A rigid cylinder rolling over a relaxing half-space (Hunter 1961) and over a bed of relaxing
// springs, both of a standard solid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "bem/steady_compliance.h"
#include "contact/bodies/cylinder.h"
#include "contact/relaxing_case.h"
#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"
#include "theory/rolling/relaxing_rolling.h"

namespace tricontact::rolling_relaxing_test {
namespace {

using rolling_test::Rig;

constexpr double ratio = 2, relaxation_time = .3;  // g = G2/G1 [-], tau [s]

/// Springs side by side, p = k u and t = k u.
class Bed final : public contact::Compliance {
  public:
    Bed(contact::ContactPoints points, double stiffness)
        : points_(std::move(points)), stiffness_(stiffness) {}
    const contact::ContactPoints& points() const override { return points_; }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        for (std::size_t i = 0; i < p.size(); ++i) u_z[i] = p[i] / stiffness_;
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        normal(t.x, u.x);
        normal(t.y, u.y);
    }
    double local_tangential() const override { return 1 / stiffness_; }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        z = r;
    }

  private:
    contact::ContactPoints points_;
    double stiffness_;
};

/// A row that sees so many half lengths of the surface ahead of the centre, and behind it.
contact::ContactPoints row(const Rig& rig, double ahead, double behind = 1.3) {
    const int back = static_cast<int>(behind * rig.n), front = static_cast<int>(ahead * rig.n);
    auto grid = contact::ContactPoints::grid(back + front + 1, 1, {-back * rig.cell(), 0},
                                             {rig.cell(), rig.row_length()});
    grid.line_length = rig.row_length();
    return grid;
}

rolling::RollingState roll(const Rig& rig, std::shared_ptr<const contact::Compliance> relaxed,
                           double force, double speed) {
    auto problem = rig.row(0);
    problem.normal.value = force;
    problem.drive.creepage = {0, 0};
    problem.speed = speed;
    problem.tolerance = 1e-7;
    const contact::RelaxingSubstrate substrate(std::move(relaxed), {{{ratio, relaxation_time}}});
    return rolling::steady_rolling(substrate, problem).state;
}

/// Solved by itself: a row so long that its ends are out of sight of all that is remembered, on a
/// grid that covers the contact alone.
rolling::RollingState steady_cylinder(const Rig& rig, double lambda) {
    const double length = 1e5 * rig.half_length, speed = lambda * rig.half_length / relaxation_time;
    auto grid = row(rig, 1.4, 1.4);
    grid.spacing[1] = grid.line_length = length;
    for (double& area : grid.area) area = grid.spacing[0] * length;
    const bem::RectangleInfluence cell(rig.materials(), grid.spacing[0], length);
    const bem::SteadyGridCompliance compliance(
        {[cell](double x, double y) { return cell.at(x, y); }},
        {{}, {contact::Retardation({{{ratio, relaxation_time}}}, 0)}, {1}}, speed, std::move(grid),
        false);
    auto problem = rig.row(0);
    problem.indenter = std::make_shared<contact::Cylinder>(rig.radius, length);
    problem.normal.value = rig.row_force() / rig.row_length() * length;
    problem.drive.creepage = {0, 0};
    return rolling::steady_rolling(compliance, problem).state;
}

// From slow to fast rolling, with what relaxes on a hundred contact lengths. The contact's edges
// fall between cells: the mean of grids that differ slightly has an order.
TEST(RollingRelaxing, TheSteadyStateIsHuntersToTheSecondOrder) {
    for (const double lambda : {.02, .1, .5, 1.5, 10., 100.}) {
        std::vector<double> error;
        for (const int coarsest : {14, 39, 112}) {
            double square = 0;
            constexpr int n_grids = 10;
            for (int k = 0; k < n_grids; ++k) {
                const Rig rig{.n = static_cast<int>(coarsest * std::exp2(k / 10.))};
                const auto state = steady_cylinder(rig, lambda);
                const auto hunter = theory::hunter_contact(
                    {rig.modulus(), rig.radius, ratio, lambda * rig.half_length},
                    rig.row_force() / rig.row_length());
                square +=
                    std::pow((state.pressure_lead - hunter.lead) / rig.half_length, 2) / n_grids;
                // Of a parabola the material dissipates what resists, F_N lead/R.
                const double resistance = state.normal_force * hunter.lead / rig.radius;
                if (coarsest == 112 && lambda < 50) {
                    EXPECT_NEAR(state.material_dissipation / resistance, 1, 3e-3);
                }
            }
            error.push_back(std::sqrt(square));
        }
        EXPECT_LT(error[2], 1e-5) << lambda;
        EXPECT_LT(error[1], error[0] / 2) << lambda;
        EXPECT_NEAR(std::log2(error[0] / error[2]) / 3, 2, .3) << lambda;
    }
}

// The surface is taken for relaxed and level where it enters the grid: the farther ahead, the more
// of what came before the material remembers.
TEST(RollingRelaxing, ACylinderThatRollsOnMeetsTheResistanceThatHunterFound) {
    for (const double lambda : {.1, .5, 1.5}) {
        std::vector<double> error;
        for (const int n : {16, 33}) {
            const Rig rig{.n = n};
            const double speed = lambda * rig.half_length / relaxation_time;
            const auto state =
                roll(rig, bem::half_space_compliance(rig.materials(), row(rig, 8 + 16 * lambda), 1),
                     rig.row_force(), speed);
            const auto hunter =
                theory::hunter_contact({rig.modulus(), rig.radius, ratio, lambda * rig.half_length},
                                       rig.row_force() / rig.row_length());
            EXPECT_NEAR(state.half_length / hunter.half_length, 1, 1.5 / n) << lambda;
            error.push_back(std::abs(state.pressure_lead / hunter.lead - 1));
            // Of a parabola: W = F_N lead/R.
            EXPECT_NEAR(state.resistance * rig.radius / (rig.row_force() * state.pressure_lead), 1,
                        1e-9);
        }
        EXPECT_LT(error[1], 2e-3) << lambda;
        // Where the way of a relaxation is some cells the grid is what errs; else what it does not
        // see ahead.
        if (lambda < .2) {
            EXPECT_LT(error[1], .5 * error[0]);
        }
    }
}

// Slow or fast the solid is elastic, relaxed or not: no resistance, and between Hertz' two lengths.
TEST(RollingRelaxing, NothingResistsSlowOrFastRolling) {
    const Rig rig{.n = 20};
    const auto relaxed = [&] {
        return bem::half_space_compliance(rig.materials(), row(rig, 5), 1);
    };
    const double unit = rig.half_length / relaxation_time;
    const auto slow = roll(rig, relaxed(), rig.row_force(), 2e-3 * unit);
    const auto middle = roll(rig, relaxed(), rig.row_force(), .4 * unit);
    const auto fast = roll(rig, relaxed(), rig.row_force(), 500 * unit);
    EXPECT_GT(middle.pressure_lead, .1 * rig.half_length);
    EXPECT_LT(std::abs(slow.pressure_lead), .02 * middle.pressure_lead);
    EXPECT_LT(std::abs(fast.pressure_lead), .05 * middle.pressure_lead);
    EXPECT_NEAR(slow.half_length, rig.half_length, rig.cell());
    EXPECT_NEAR(fast.half_length, rig.half_length / std::sqrt(1 + ratio), rig.cell());
}

// What rolling takes of work the material dissipates, much of it behind the contact. The work of a
// step, means of pressures times displacements, is second order in the cell but at the edges.
TEST(RollingRelaxing, TheMaterialDissipatesWhatResistanceWorks) {
    std::vector<double> error;
    for (const int n : {16, 33}) {
        const Rig rig{.n = n};
        const auto state =
            roll(rig, bem::half_space_compliance(rig.materials(), row(rig, 12, 12), 1),
                 rig.row_force(), .5 * rig.half_length / relaxation_time);
        EXPECT_EQ(state.dissipation, 0);
        error.push_back(std::abs(state.material_dissipation / state.resistance - 1));
    }
    EXPECT_LT(error[1], .35 * error[0]);
    EXPECT_LT(error[1], 1e-3);
}

// Slow rolling takes W = F_N sum g_i v tau_i/R of any paraboloid
// (theory/rolling/relaxing_rolling.h); what comes next is linear in the speed.
TEST(RollingRelaxing, SlowRollingOfASphereResistsLikeAViscousForce) {
    const Rig rig{.n = 12};
    std::vector<double> error;
    for (const double lambda : {.1, .05}) {
        auto problem = rig.sphere(0);
        problem.drive.creepage = {0, 0};
        problem.speed = lambda * rig.half_length / relaxation_time;
        problem.tolerance = 1e-7;
        const contact::Relaxation relaxation{{{ratio, relaxation_time}}};
        const contact::RelaxingSubstrate substrate(rig.sphere_grid(), relaxation);
        const auto state = rolling::steady_rolling(substrate, problem).state;
        error.push_back(state.resistance / state.normal_force /
                            theory::slow_resistance_ratio(relaxation, problem.speed, rig.radius) -
                        1);
    }
    EXPECT_NEAR(2 * error[1] - error[0], 0, 3e-2);
    EXPECT_LT(std::abs(error[1]), .7 * std::abs(error[0]));
}

TEST(RollingRelaxing, ABedOfRelaxingSpringsIsExact) {
    const double lambda = .7, stiffness = 4e8;  // of the leading edge's distance a; [Pa/m]
    std::vector<double> error;
    for (const int n : {20, 41, 80}) {
        const Rig rig{.n = n};
        const double a = rig.half_length, speed = lambda * a / relaxation_time;
        const auto exact = theory::foundation_contact(
            {{{{ratio, relaxation_time}}}, speed, stiffness, rig.radius}, a);
        const auto state = roll(rig, std::make_shared<Bed>(row(rig, 2), stiffness),
                                exact.force * rig.row_length(), speed);
        EXPECT_NEAR(state.indentation, a * a / (2 * rig.radius), .5 / n * state.indentation);
        error.push_back(state.pressure_lead / exact.lead - 1);
    }
    EXPECT_LT(std::abs(error[2]), 1e-2);
    EXPECT_LT(std::abs(error[2]), .5 * std::abs(error[0]));
}

}  // namespace
}  // namespace tricontact::rolling_relaxing_test
