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

constexpr double R = 10, clearance = .05;  // mm

struct Radii {
    double pin, hub, plate;
};

std::vector<CondensedSection> pin_and_hole(const Sizes& sizes, const Radii& r,
                                           const contact::Material& pin,
                                           const contact::Material& plate) {
    const auto body = [&](const Mesh& half, const contact::Material& material) {
        return body_of(with_mirror_image(half), Solid::plane_strain, material, Support::bonded,
                       Frame::round, r.pin);
    };
    return {body(pin_section(sizes, r.pin, r.hub), pin),
            body(hole_section(sizes, r.pin, r.plate), plate)};
}

fem::ConformingModel model_of(const std::vector<CondensedSection>& bodies, double radius,
                              double hole_radius, double mu) {
    PairOptions options{.radius = radius};
    options.conforming = options.with_friction = true;
    contact::Friction friction;
    friction.coefficient = mu;
    const auto along_arc = std::make_shared<const fem::ConformingFriction>(friction.law(), radius);
    auto along_z = std::make_unique<contact::SurfaceModel>(
        "fem-plane", pair_compliance(bodies, grid_between(bodies), options),
        std::make_unique<contact::PinInHole>(radius, hole_radius), along_arc, 1e-6,
        contact::Case::Contact{});
    return {std::move(along_z), radius, along_arc};
}

contact::StepRecord press_to(contact::Model& model, const contact::NormalControl& control) {
    contact::LoadStep step;
    step.normal = control;
    step.tangential[0] = {contact::TangentialControl::Kind::force, 0};
    step.friction = true;
    step.in_proportion = control.kind == contact::NormalControl::Kind::force;
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
    double mu;
    Surface surface;
    std::vector<double> moved;  // of the pin over the hole along the arc [mm]
};

void expect_contact(const contact::Compliance& own, double depth, double force, const State& before,
                    State& now) {
    const contact::PinInHole shape(R, R + clearance);
    const Surface& s = now.surface;
    const double mu = now.mu;
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
    const auto bodies = pin_and_hole({24, .5, 1.3, 3}, {R, 2, 100}, {2, .3}, {4, .45});
    const auto own = pair_compliance(bodies, grid_between(bodies), {.radius = R});
    constexpr double mu = .3;
    fem::ConformingModel model = model_of(bodies, R, R + clearance, mu);
    State before{};
    std::vector<double> forces;
    double dissipated = 0;
    for (const double depth : {.02, .04, .06, .08, .06, .04, .02}) {
        const contact::StepRecord record =
            press_to(model, {contact::NormalControl::Kind::indentation, depth});
        State now{mu, model.surface(), {}};
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

// Where mu tan(theta) is above 1 as well: the same equations hold. A pin that is taken back jams
// there, which Coulomb's law leaves undetermined; and where pressures and tractions do not settle,
// what to do is said.
TEST(FemConformingFriction, PressesWhereAPinThatIsTakenBackJams) {
    const auto bodies = pin_and_hole({24, .6, 1.5, 3}, {R, 2, 100}, {2, .3}, {4, .45});
    const auto own = pair_compliance(bodies, grid_between(bodies), {.radius = R});
    constexpr double mu = .3, step = .04;
    fem::ConformingModel model = model_of(bodies, R, R + clearance, mu);
    State before{};
    for (int k = 1; k < 8; ++k) {
        const contact::StepRecord record =
            press_to(model, {contact::NormalControl::Kind::indentation, k * step});
        State now{mu, model.surface(), {}};
        expect_contact(*own, k * step, record.normal_force, before, now);
        before = std::move(now);
    }
    double edge = 0;
    for (std::size_t i = 0; i < before.surface.size(); ++i)
        if (before.surface.normal_traction[i] > 0)
            edge = std::max(edge, before.surface.x(static_cast<int>(i)) / R);
    EXPECT_GT(mu * std::tan(edge), 1.02);
    fem::ConformingModel resumed = model_of(bodies, R, R + clearance, mu);
    resumed.read_state(model.write_state());
    for (fem::ConformingModel* const one : {&model, &resumed})
        EXPECT_THROW(press_to(*one, {contact::NormalControl::Kind::indentation, 6 * step}),
                     contact::InputError);
    fem::ConformingModel rough = model_of(bodies, R, R + clearance, 1.5);
    try {
        press_to(rough, {contact::NormalControl::Kind::indentation, .1});
        FAIL() << "it converges";
    } catch (const contact::NotConverged& error) {
        EXPECT_NE(std::string(error.what()).find("lower friction.coefficient"), std::string::npos);
    }
}

// Friction needs another compliance than a press without it: such a model has no coupled sibling.
TEST(FemConformingFriction, IsNoSiblingOfAPressWithoutIt) {
    const auto bodies = pin_and_hole({12, .6, 1.5, 3}, {R, 2, 100}, {2, .3}, {4, .45});
    PairOptions options{.radius = R};
    options.conforming = true;
    const fem::ConformingModel alone(
        std::make_unique<contact::SurfaceModel>(
            "fem-plane", pair_compliance(bodies, grid_between(bodies), options),
            std::make_unique<contact::PinInHole>(R, R + clearance), contact::Friction{}.law(), 1e-6,
            contact::Case::Contact{.coupling = false}),
        R, nullptr);
    EXPECT_EQ(alone.sibling({.coupling = true}), nullptr);
    EXPECT_NE(alone.sibling({.coupling = false}), nullptr);
    const fem::ConformingModel rough = model_of(bodies, R, R + clearance, .3);
    EXPECT_NE(rough.sibling({.coupling = true}), nullptr);
}

// CalculiX 2.20 on the benchmark's deck with 8 elements in a, face to face with its own friction on
// displaced surfaces, mu = .3, its load in 10 increments: depths of 19.004 um without friction and
// 18.705 um with it, 54.0 MPa in the middle, tractions of 4.61, 8.33 and 12.06 MPa at 7.5, 11.25
// and 15 degrees, and slip from 18.75 degrees on. Its pressures go up and down by 1 %.
TEST(FemConformingFriction, IsThatOfCalculix) {
    const auto bodies =
        pin_and_hole({18, 8. / 18, 1.2, 3}, {9.98, .2, 998}, {210000, .3}, {70000, .45});
    fem::ConformingModel model = model_of(bodies, 9.98, 10, .3);
    contact::StepRecord record;
    for (int k = 1; k <= 10; ++k)
        record = press_to(model, {contact::NormalControl::Kind::force, 581.0237 * k / 10});
    EXPECT_NEAR(record.indentation / .018705, 1, .003);
    const Surface s = model.surface();
    double last_stick = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double x = s.x(static_cast<int>(i)), degrees = x / 9.98 * 180 / std::numbers::pi;
        if (s.contact_state[i] == ContactState::stick) last_stick = std::max(last_stick, degrees);
    }
    EXPECT_NEAR(s.normal_traction[s.size() / 2] / 54.0, 1, .01);
    EXPECT_NEAR(last_stick, 18.75, 2);
}

}  // namespace
}  // namespace tricontact::conforming_friction_test
