// Rolling of dissimilar bodies and over a thin layer: what the normal load alone makes of creepage
// (Bentall & Johnson 1967), energy, and the limit in which the layer is a bed of shear springs.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "rolling/linear_creep.h"
#include "rolling/steady_rolling.h"
#include "tests/unit/rolling_problems.h"
#include "theory/case_layers.h"

namespace tricontact {
namespace {

using rolling_test::Rig;

constexpr double beta = .5;  // of a rigid cylinder on a substrate without Poisson's ratio

/// Rolling freely. Creepage over a/R and half length over a, a being Hertz' without friction.
struct Free {
    double creepage, half_length, cell;
};
Free roll_freely(double friction, int n) {
    Rig rig{.n = n};
    rig.substrate.poisson = 0;
    rig.friction = friction;
    auto problem = rig.row(0);
    problem.tolerance = 1e-7;
    const auto state = rolling::steady_rolling(*rig.row_grid(), problem).state;
    return {state.creepage.longitudinal * rig.radius / rig.half_length,
            state.half_length / rig.half_length, 1. / n};
}

// All sticks: p + i q is a multiple of (a - x)^(1/2 + i e) (a + x)^(1/2 - i e), the solution of the
// coupled singular integral equations that is bounded at both edges (Muskhelishvili 1953), e =
// ln((1 + beta)/(1 - beta))/(2 pi). Its expansion at infinity,
//   z - 2 i e a - (1/2 + 2 e^2) a^2/z,
// tells the creepage xi = 2 e a/R and the force F_N = pi E* a^2 (1 + 4 e^2)/(4 R) per length.
// Friction that no longer slips anywhere lets the edges' oscillation through to a cell: first
// order.
TEST(RollingDissimilar, ARoughRollerCreepsUnderItsNormalLoadAlone) {
    const double e = std::log((1 + beta) / (1 - beta)) / (2 * std::numbers::pi);
    const double a = 1 / std::sqrt(1 + 4 * e * e);
    std::vector<double> error;
    for (const int n : {61, 120, 240}) {
        const Free rolled = roll_freely(6, n);
        EXPECT_NEAR(rolled.half_length, a, rolled.cell);
        error.push_back(std::abs(rolled.creepage / (2 * e * a) - 1));
    }
    EXPECT_LT(error[2], .6 * error[0]);
    EXPECT_LT(error[2], 6e-3);
}

// Little friction leaves Hertz' pressure alone: the surface creeps by xi - 2 beta p/E* and slips
// forwards beside the strip that carries half the load, backwards in it. That strip is |x| < .404
// a, so xi = .9148 beta a/R: more than where all sticks. What friction does is of the order mu.
TEST(RollingDissimilar, ASmoothRollerCreepsMore) {
    double y = .4;  // of (2/pi) (asin y + y sqrt(1 - y^2)) = 1/2, Newton
    for (int k = 0; k < 20; ++k)
        y -= (std::asin(y) + y * std::sqrt(1 - y * y) - std::numbers::pi / 4) /
             (2 * std::sqrt(1 - y * y));
    const double smooth = beta * std::sqrt(1 - y * y);
    const double error = 1 - roll_freely(4e-3, 61).creepage / smooth;
    const double half = 1 - roll_freely(2e-3, 61).creepage / smooth;
    EXPECT_NEAR(half, 0, 4e-3);
    EXPECT_NEAR(2 * half - error, 0, 1e-3);
}

TEST(RollingDissimilar, WithoutCouplingAFreeRollerDoesNotCreep) {
    Rig rig{.n = 20};
    rig.substrate.poisson = 0;
    auto problem = rig.row(0);
    problem.coupling = false;
    const auto state = rolling::steady_rolling(*rig.row_grid(), problem).state;
    EXPECT_NEAR(state.creepage.longitudinal, 0, 1e-9 * rig.creepage());
    EXPECT_EQ(state.slip_area, 0);
}

// Carried tractions of an elastic body do no work on what they displace: what friction dissipates
// is the creepage's work and the normal load's on the way that coupling tilts it. On a grid with
// the half square of what each cell's step changes, its order h.
TEST(RollingDissimilar, EnergyIsConserved) {
    Rig rig{.n = 12};
    rig.substrate.poisson = .2;
    auto problem = rig.sphere(.4);
    problem.tolerance = 1e-8;
    problem.drive.spin = .6 * rig.friction / rig.radius;
    const auto grid = rig.sphere_grid();
    const auto [state, s, audit] = rolling::steady_rolling(*grid, problem);
    EXPECT_TRUE(audit.passed());

    const std::size_t n = s.size();
    const auto ahead = [&](const std::vector<double>& f, std::size_t i) {
        return (i + 1) % s.n_x == 0 ? 0 : f[i + 1];
    };
    contact::TangentialField change(n), u(n), by_pressure(n);
    std::vector<double> change_p(n), u_z(n), by_friction(n);
    double normal_work = 0;
    for (std::size_t i = 0; i < n; ++i) {
        change.x[i] = s.tangential_traction_x[i] - ahead(s.tangential_traction_x, i);
        change.y[i] = s.tangential_traction_y[i] - ahead(s.tangential_traction_y, i);
        change_p[i] = s.normal_traction[i] - ahead(s.normal_traction, i);
        if (s.normal_traction[i] > 0)
            normal_work += s.normal_traction[i] * (s.displacement_z[i + 1] - s.displacement_z[i]);
    }
    grid->tangential(change, u);
    grid->tangential_from_normal(change_p, by_pressure);
    grid->normal(change_p, u_z);
    grid->normal_from_tangential(change, by_friction);
    double of_step = 0;
    for (std::size_t i = 0; i < n; ++i)
        of_step +=
            (change.x[i] * (u.x[i] + by_pressure.x[i]) + change.y[i] * (u.y[i] + by_pressure.y[i]) +
             change_p[i] * (u_z[i] + by_friction[i])) /
            2;
    const double per_way = rig.cell();  // cell's area over its length
    const double creepage_work = state.creepage.longitudinal * state.force[0] +
                                 state.creepage.lateral * state.force[1] +
                                 state.creepage.spin * state.spin_moment;
    EXPECT_NEAR(creepage_work - per_way * (normal_work + of_step), state.dissipation,
                1e-6 * state.dissipation);
    EXPECT_GT(state.dissipation, 0);
}

// A bonded layer much thinner than the contact is a bed of springs G/b: while all sticks its shear
// grows from the leading edge, F_x = 2 G a^2 L/b xi (Kalker's simplified theory, 1973).
TEST(RollingDissimilar, AThinLayerIsABedOfShearSprings) {
    const Rig rig{.n = 160};
    std::vector<double> error;
    for (const double thickness : {.2, .1, .05}) {
        const double b = thickness * rig.half_length;
        contact::Case c;
        c.substrate = {3e6, .3};
        c.layer.thickness = b;
        const int beside = rig.n + 3;
        auto grid = contact::ContactPoints::grid(2 * beside + 1, 1, {-beside * rig.cell(), 0},
                                                 {rig.cell(), rig.row_length()});
        grid.line_length = rig.row_length();
        const auto compliance = bem::plane_layer_compliance(theory::layers_of("bem-layer", c),
                                                            std::nullopt, std::move(grid), 1);
        std::vector<double> pressure(compliance->points().size());
        for (std::size_t i = 0; i < pressure.size(); ++i)
            pressure[i] = std::abs(compliance->points().x[i]) < rig.half_length;
        const double force = rolling::linear_creep(*compliance, pressure)[0][0];
        error.push_back(force / (2 * c.substrate.shear_modulus() * rig.half_length *
                                 rig.half_length * rig.row_length() / b) -
                        1);
    }
    EXPECT_NEAR(error[1] / error[0], .5, .1);
    EXPECT_NEAR(error[2] / error[1], .5, .1);
    EXPECT_NEAR(2 * error[2] - error[1], 0, 1e-2);
}

}  // namespace
}  // namespace tricontact
