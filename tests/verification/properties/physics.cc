// What every step of every model must fulfil, checked from its fields on random cases.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/cells.h"
#include "tests/verification/properties/cases.h"

namespace tricontact::properties::properties_physics_test {
namespace {

using contact::ContactState;
using contact::dot;
using contact::norm;
using contact::Surface;
using contact::Vector2;

/// Sums over the grid between two states.
struct Balance {
    Vector2 force{};
    double normal_force = 0;
    double stored_before = 0, stored = 0;  // 1/2 t.u [J]
    double work = 0;                       // mean t . dU
    double friction = 0;                   // mean t . slip
};

Balance balance_of(const Surface& before, const Surface& s, const Vector2& shift) {
    Balance b;
    const double cell = s.spacing[0] * s.spacing[1];
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Vector2 t = {s.tangential_traction_x[i], s.tangential_traction_y[i]};
        const Vector2 t0 = {before.tangential_traction_x[i], before.tangential_traction_y[i]};
        const Vector2 u = {s.displacement_x[i], s.displacement_y[i]};
        const Vector2 u0 = {before.displacement_x[i], before.displacement_y[i]};
        b.normal_force += cell * s.normal_traction[i];
        b.stored += cell * dot(t, u) / 2;
        b.stored_before += cell * dot(t0, u0) / 2;
        for (int d = 0; d < 2; ++d) {
            b.force[d] += cell * t[d];
            b.work += cell * (t[d] + t0[d]) / 2 * shift[d];
            b.friction += cell * (t[d] + t0[d]) / 2 * (shift[d] - (u[d] - u0[d]));
        }
    }
    return b;
}

/// Friction bound, and slip along the traction: what the indenter drags, it drags its own way.
void check_points(const Surface& s, double friction, double unit) {
    double mean_bound = 0;
    int n = 0;
    for (const double bound : s.friction_bound)
        if (bound > 0) mean_bound += bound, ++n;
    mean_bound /= n;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const Vector2 t = {s.tangential_traction_x[i], s.tangential_traction_y[i]};
        const Vector2 slip = {s.slip_x[i], s.slip_y[i]};
        RC_ASSERT(s.normal_traction[i] >= 0);
        RC_ASSERT(norm(t) <= friction * s.normal_traction[i] + 1e-12 * mean_bound);
        RC_ASSERT(s.dissipation[i] >= 0);
        if (s.contact_state[i] != ContactState::slip) continue;
        // tolerance 1e-7 of slip over mu d and of the angle between slip and traction
        const double allowed = 1e-6 * unit;
        RC_ASSERT(dot(slip, t) >= -allowed * norm(t));
        RC_ASSERT(std::abs(slip[0] * t[1] - slip[1] * t[0]) <=
                  (allowed + 1e-6 * norm(slip)) * norm(t));
    }
}

void check_audit(const contact::Model& model) {
    for (const auto& check : model.audit().checks()) {
        RC_LOG() << check.name << ' ' << check.worst << '\n';
        RC_ASSERT(check.passed());
    }
}

/// One step of the boundary elements, from the fields before and after; what it dissipates.
double check_step(const contact::Case& c, contact::Model& model, const contact::LoadStep& step,
                  Vector2& shift) {
    const Surface before = model.surface();
    const auto record = model.advance(step);
    const Surface s = model.surface();
    const double unit = c.friction_coefficient() * record.indentation;
    check_points(s, c.friction_coefficient(), unit);
    const Vector2 increment = {record.shift[0] - shift[0], record.shift[1] - shift[1]};
    shift = record.shift;
    const Balance b = balance_of(before, s, increment);
    const double limit = c.friction_coefficient() * b.normal_force;
    if (step.normal.kind == contact::NormalControl::Kind::force)
        RC_ASSERT(std::abs(b.normal_force / step.normal.value - 1) <= 1e-9);
    for (int d = 0; d < 2; ++d)
        if (step.tangential[d].kind == contact::TangentialControl::Kind::force)
            RC_ASSERT(std::abs(b.force[d] - step.tangential[d].value) <= 1e-9 * limit);
    // The trapezoidal rule is exact for a self-adjoint compliance: rounding only.
    const double defect = b.work - (b.stored - b.stored_before) - b.friction;
    RC_ASSERT(std::abs(defect) <= 1e-10 * limit * unit);
    return record.dissipation;
}

RC_GTEST_PROP(PropertiesPhysics, EveryStepOfTheBoundaryElementsIsSound, ()) {
    contact::Case c = random_richer_case();
    c.contact.coupling = false;  // check_step balances the tangential energy alone
    const auto model = bem::make_model(c, 1);
    model->advance(contact::press_step(c));
    const auto scales = model->scales();
    const auto path = contact::make_load_path(c, scales.normal_force, scales.contact_radius);
    Vector2 shift{};
    for (const auto& step : path.loading) check_step(c, *model, step, shift);
    for (int n = 0; n < 2; ++n) {
        model->start_period();
        double dissipated = 0, work = 0;
        for (const auto& step : path.period) dissipated += check_step(c, *model, step, shift);
        const Surface s = model->surface();
        for (const double each : s.friction_work) work += s.spacing[0] * s.spacing[1] * each;
        RC_ASSERT(std::abs(work - dissipated) <= 1e-12 * dissipated);  // rounding of sums
    }
    check_audit(*model);
}

// Any walk: both directions, forces and shifts, any normal force and position within the grid.
RC_GTEST_PROP(PropertiesPhysics, RandomWalksOfTheBoundaryElementsAreSound, ()) {
    contact::Case c = random_case();
    c.contact.coupling = false;
    c.rolling->angle = std::numbers::pi / 4;
    const auto model = bem::make_model(c, 1);
    const auto press = contact::press_step(c);
    model->advance(press);
    const double limit = c.friction_coefficient() * *c.load.normal_force;
    const auto scales = contact::half_space_scales(c);
    const double reach = *c.rolling->amplitude_ratio * scales.contact_radius / std::sqrt(2);
    Vector2 shift{};
    for (int k = 0; k < 6; ++k) {
        contact::LoadStep step = press;
        const double part = drawn(.3, 1);
        step.normal.value *= part;
        step.offset = {drawn(-reach, reach), drawn(-reach, reach)};
        const double force = drawn(0, .99) * part * limit, angle = drawn(0, 6.3);
        const double direction[] = {std::cos(angle), std::sin(angle)};
        for (int d = 0; d < 2; ++d) {
            if (*rc::gen::arbitrary<bool>())
                step.tangential[d] = {contact::TangentialControl::Kind::shift,
                                      drawn(-1, 1) * scales.unit_shift};
            else
                step.tangential[d].value = force * direction[d];
        }
        check_step(c, *model, step, shift);
    }
    check_audit(*model);
}

RC_GTEST_PROP(PropertiesPhysics, EveryStepOfTheSpringBedIsSound, ()) {
    const contact::Case c = random_richer_case();
    const auto model = mdr::make_model(c);
    const auto h = contact::run(c, *model);
    for (const auto& step : h.steps) {
        const double limit = c.friction_coefficient() * step.normal_force;
        RC_ASSERT(step.force_residual <= 1e-12);
        RC_ASSERT(step.dissipation >= -1e-12 * limit * h.scales.unit_shift);
        RC_ASSERT(std::abs(step.tangential_force[0]) <= limit);
    }
    check_audit(*model);
}

/// External work - elastic energy - dissipation as the program sums it, over mu F_N U_max.
/// Boundary elements only: their fields give the elastic energy.
double energy_defect(contact::Case c, int steps_per_quarter) {
    c.rolling->steps_per_quarter = steps_per_quarter;
    const auto model = bem::make_model(c, 1);
    const auto h = contact::run(c, *model);
    double work = 0, dissipation = 0;
    // from the loaded state on, which one step reaches
    for (std::size_t k = 2; k < h.steps.size(); ++k) {
        work += h.tangential_force * (h.steps[k].shift[0] - h.steps[k - 1].shift[0]);
        dissipation += h.steps[k].dissipation;
    }
    auto stored = [](const Surface& s) { return balance_of(s, s, {}).stored; };
    const double change = stored(h.snapshots.back().surface) - stored(h.snapshots.front().surface);
    return (work - change - dissipation) / (h.friction_limit * h.scales.unit_shift);
}

TEST(PropertiesPhysics, DissipationIsFirstOrderInTheStep) {
    for (const double angle : {0., 1.}) {
        contact::Case c;
        c.indenter.radius = .04;
        c.substrate = {5.2e6, .5};
        c.friction.coefficient = .57;
        c.load.normal_force = 21.1;
        c.load.tangential_ratio = .5;
        c.rolling.emplace();
        c.rolling->amplitude_ratio = .6;
        c.rolling->angle = angle;
        c.rolling->periods = 2;
        c.rolling->run_all = true;
        c.of<contact::Cells>().per_radius = 12;
        const double coarse = energy_defect(c, 4), medium = energy_defect(c, 8),
                     fine = energy_defect(c, 16);
        // The traction at the end of the step stands for that on the way.
        EXPECT_NEAR(std::log2(coarse / medium), 1, .35) << angle;  // cells join one by one
        EXPECT_NEAR(std::log2(medium / fine), 1, .35) << angle;
        EXPECT_LT(std::abs(fine), .1) << angle;
    }
}

}  // namespace
}  // namespace tricontact::properties::properties_physics_test
