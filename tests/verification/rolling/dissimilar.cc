// Rolling of dissimilar bodies and over a thin layer: what the normal load alone makes of creepage
// (Bentall & Johnson 1967), energy, and the limit in which the layer is a bed of shear springs.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "contact/substrates/substrate.h"
#include "rolling/linear_creep.h"
#include "rolling/run.h"
#include "tests/unit/rolling/problems.h"
#include "theory/creep_law.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::rolling_dissimilar_test {
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

/// Over b/R, of a rigid body x^2/(2 R) + f(y) that slips everywhere, mu far below b/a, on a bonded
/// layer of the thickness b, much thinner than the contact: (1 - 4 nu)/(2 (1 - 2 nu)). Pressed in
/// by w(x) such a layer bulges by -(1 - 4 nu)/(2 (1 - 2 nu)) b w' along x, and no correction of
/// higher order comes from a parabola, which stretches it evenly. Who sticks creeps less: at the
/// leading edge the surface comes in with half of that. nu < 1/2: an incompressible thin layer
/// gives way by flowing.
double thin_layer_smooth_creepage(double poisson) {
    return (1 - 4 * poisson) / (2 * (1 - 2 * poisson));
}

// All sticks. Friction that no longer slips anywhere lets the edges' oscillation through to a cell:
// first order.
TEST(RollingDissimilar, ARoughRollerCreepsUnderItsNormalLoadAlone) {
    const double rough = theory::rough_free_creepage(beta);
    std::vector<double> error;
    for (const int n : {61, 120, 240}) {
        const Free rolled = roll_freely(6, n);
        // a/a_Hertz = 1/sqrt(1 + 4 e^2), 2 e times which the creepage is.
        EXPECT_NEAR(rolled.half_length, std::sqrt(1 - rough * rough), rolled.cell);
        error.push_back(std::abs(rolled.creepage / rough - 1));
    }
    EXPECT_LT(error[2], .6 * error[0]);
    EXPECT_LT(error[2], 6e-3);
}

// Little friction leaves Hertz' pressure alone. What it does is of the order mu.
TEST(RollingDissimilar, ASmoothRollerCreepsMore) {
    const double smooth = theory::smooth_free_creepage(beta);
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
    const auto result = rolling::steady_rolling(*grid, problem);
    const auto& [state, s, audit, temperatures] = result;
    EXPECT_TRUE(audit.passed());
    EXPECT_FALSE(temperatures);

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
    const double creepage_work =
        state.creepage.longitudinal * state.force[0] + state.creepage.lateral * state.force[1] +
        state.creepage.spin *
            (state.spin_moment + contact::spin_point * rig.cell() * state.force[1]);
    EXPECT_NEAR(creepage_work - per_way * (normal_work + of_step), state.dissipation,
                1e-6 * state.dissipation);
    EXPECT_GT(state.dissipation, 0);
}

/// A row over a bonded layer of this thickness [m].
std::shared_ptr<const contact::Compliance> thin_layer(const Rig& rig, double poisson,
                                                      double thickness) {
    contact::Case c;
    c.substrate = {3e6, poisson};
    c.layer.thickness = thickness;
    const int beside = rig.n + 3;
    auto grid = contact::ContactPoints::grid(2 * beside + 1, 1, {-beside * rig.cell(), 0},
                                             {rig.cell(), rig.row_length()});
    grid.line_length = rig.row_length();
    return bem::plane_layer_compliance(theory::layers_of("bem-layer", c), std::nullopt,
                                       std::move(grid), 1);
}

// Free rolling on a bonded layer creeps by itself: forwards below nu = 1/4, backwards above. The
// closed form is that of a vanishing thickness; the edges take parts of the contact of that order,
// and weigh the more the less the layer can be compressed.
TEST(RollingDissimilar, ARollerOnAThinLayerCreepsByItself) {
    const Rig rig{.friction = 2.5e-4, .n = 60};
    for (const auto& [nu, allowed] : {std::pair(0., .02), std::pair(.4, .07)}) {
        std::vector<double> error;
        for (const double thickness : {.2, .1}) {
            const double b = thickness * rig.half_length;
            auto problem = rig.row(0);
            problem.normal = {contact::NormalControl::Kind::indentation,
                              rig.half_length * rig.half_length / (2 * rig.radius)};
            problem.tolerance = 1e-7;
            const auto state = rolling::steady_rolling(*thin_layer(rig, nu, b), problem).state;
            error.push_back(state.creepage.longitudinal /
                                (b / rig.radius * thin_layer_smooth_creepage(nu)) -
                            1);
        }
        EXPECT_NEAR(error[1], 0, allowed) << nu;
        EXPECT_LT(std::abs(error[1]), .3 * std::abs(error[0])) << nu;
    }
}

// A bonded layer much thinner than the contact is a bed of springs G/b: while all sticks its shear
// grows from the leading edge, F_x = 2 G a^2 L/b xi (Kalker's simplified theory, 1973).
TEST(RollingDissimilar, AThinLayerIsABedOfShearSprings) {
    const Rig rig{.n = 160};
    std::vector<double> error;
    for (const double thickness : {.2, .1, .05}) {
        const double b = thickness * rig.half_length;
        const auto compliance = thin_layer(rig, .3, b);
        std::vector<double> pressure(compliance->points().size());
        for (std::size_t i = 0; i < pressure.size(); ++i)
            pressure[i] = std::abs(compliance->points().x[i]) < rig.half_length;
        const double force = rolling::linear_creep(*compliance, pressure)[0][0];
        error.push_back(force / (2 * contact::Material{3e6, .3}.shear_modulus() * rig.half_length *
                                 rig.half_length * rig.row_length() / b) -
                        1);
    }
    EXPECT_NEAR(error[1] / error[0], .5, .1);
    EXPECT_NEAR(error[2] / error[1], .5, .1);
    EXPECT_NEAR(2 * error[2] - error[1], 0, 1e-2);
}

}  // namespace
}  // namespace tricontact::rolling_dissimilar_test
