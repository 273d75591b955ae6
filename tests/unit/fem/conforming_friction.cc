// Pins pressed in holes with friction: the equations of contact along arc and radius, which the
// model solves in others.

#include "fem/case/conforming_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/bodies/pin_in_hole.h"
#include "contact/surface_model.h"
#include "fem/case/conforming_model.h"
#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::conforming_friction_test {
namespace {

using namespace planar_test;
using contact::ContactState;
using contact::Surface;

constexpr double R = 10, clearance = .05, mu = .3;  // mm

std::vector<CondensedSection> pin_and_hole() {
    const Sizes sizes{24, .5, 1.3, 3};
    return {body_of(with_mirror_image(pin_section(sizes, R, 2)), Solid::plane_strain, {2, .3},
                    Support::bonded, Frame::round, R),
            body_of(with_mirror_image(hole_section(sizes, R, 100)), Solid::plane_strain, {4, .45},
                    Support::bonded, Frame::round, R)};
}

contact::StepRecord press_to(contact::Model& model, double depth) {
    contact::LoadStep step;
    step.normal = {contact::NormalControl::Kind::indentation, depth};
    step.tangential[0] = {contact::TangentialControl::Kind::force, 0};
    step.friction = true;
    return model.advance(step);
}

/// Along arc (0) and radius (1): displacements of the hole less those of the pin, by their own
/// compliance.
std::array<std::vector<double>, 2> displaced(const contact::Compliance& own, const Surface& s) {
    const std::size_t n = own.points().size();
    std::array<std::vector<double>, 2> u{std::vector<double>(n, 0), std::vector<double>(n, 0)};
    for (std::size_t k = 0; k < n; ++k) {
        const double area = own.points().area[k];
        const double* const by_t = own.dense() + k * 3 * n;
        const double* const by_p = own.dense() + (2 * n + k) * 3 * n;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t d = 0; d < 2; ++d)
                u[d][i] += area * (by_t[2 * d * n + i] * s.tangential_traction_x[k] +
                                   by_p[2 * d * n + i] * s.normal_traction[k]);
    }
    return u;
}

struct State {
    Surface surface;
    std::vector<double> moved;  // of the pin over the hole along the arc [mm]
};

void expect_contact(const contact::Compliance& own, double depth, double force, const State& before,
                    State& now) {
    const contact::PinInHole shape(R, R + clearance);
    const Surface& s = now.surface;
    const auto u = displaced(own, s);
    now.moved.resize(s.size());
    double carried = 0, peak = 0;
    for (const double p : s.normal_traction) peak = std::max(peak, p);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double x = own.points().x[i], angle = x / R, p = s.normal_traction[i],
                     t = s.tangential_traction_x[i];
        const double gap = (shape.height(x, 0) - depth) * std::cos(angle) + u[1][i];
        now.moved[i] = -(u[0][i] + depth * std::sin(angle));
        carried += own.points().area[i] * (p * std::cos(angle) - t * std::sin(angle));
        EXPECT_GE(p, -1e-9 * peak);
        EXPECT_GT(gap / depth, -1e-5) << i;
        EXPECT_TRUE(!(p > 0) || gap / depth < 1e-5) << i;
        EXPECT_LE(std::abs(t), mu * p + 1e-4 * mu * peak) << i;
        // Points that were not pressed before have not slipped from there.
        if (before.moved.empty() || !(p > 0) || !(before.surface.normal_traction[i] > 0)) continue;
        const double slip = now.moved[i] - before.moved[i];
        if (s.contact_state[i] == ContactState::stick) {
            EXPECT_NEAR(slip / clearance, 0, 1e-4) << i;
        }
        if (s.contact_state[i] == ContactState::slip) {
            EXPECT_NEAR(std::abs(t), mu * p, 1e-3 * mu * peak) << i;
            EXPECT_GT(t * slip, -1e-5 * peak * clearance) << i;
        }
    }
    EXPECT_NEAR(carried / force, 1, 1e-6);
}

// Signorini's and Coulomb's conditions by tractions and displacements along arc and radius, of the
// compliance that knows of no other directions, at all steps of a press and while it is taken back:
// then points slip the other way, and the force is less at the same depth. Both halves are images
// of one another.
TEST(FemConformingFriction, SolvesContactAlongArcAndRadius) {
    const auto bodies = pin_and_hole();
    const ContactGrid grid = grid_between(bodies);
    PairOptions options{.radius = R};
    const auto own = pair_compliance(bodies, grid, options);
    options.conforming = options.with_friction = true;
    auto along_z = std::make_unique<contact::SurfaceModel>(
        "fem-plane", pair_compliance(bodies, grid, options),
        std::make_unique<contact::PinInHole>(R, R + clearance),
        std::make_shared<fem::ConformingFriction>(contact::Friction{.coefficient = mu}.law(), R),
        1e-6, contact::Case::Contact{});
    fem::ConformingModel model(std::move(along_z), R);
    State before;
    std::vector<double> forces;
    double dissipated = 0;
    for (const double depth : {.02, .04, .06, .08, .06, .04, .02}) {
        const contact::StepRecord record = press_to(model, depth);
        State now{model.surface(), {}};
        expect_contact(*own, depth, record.normal_force, before, now);
        const std::size_t n = now.surface.size();
        for (std::size_t i = 0; i < n; ++i)
            EXPECT_NEAR(now.surface.tangential_traction_x[i],
                        -now.surface.tangential_traction_x[n - 1 - i],
                        1e-4 * mu * now.surface.normal_traction[n / 2]);
        dissipated += record.dissipation;
        forces.push_back(record.normal_force);
        before = std::move(now);
    }
    // What is lost is the loop between force and depth, less what stays stored at its end.
    EXPECT_GT(dissipated, 0);
    EXPECT_LT(forces[4], .999 * forces[2]);
    EXPECT_LT(forces[5], .999 * forces[1]);
    for (const auto& check : model.audit().checks()) EXPECT_TRUE(check.passed()) << check.name;
}

}  // namespace
}  // namespace tricontact::conforming_friction_test
