#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "contact/base/error.h"
#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::lost_contact_test {

/// A standard solid, G(t)/G_inf = 1 + ratio exp(-t/tau), in shear and bulk alike.
constexpr double ratio = 1.7, tau = .3;
constexpr double depth = 4e-4, raised = .3 * depth;  // [m]

inline contact::Case relaxing(contact::Case c) {
    c.load = {};
    c.load.indentation = depth;
    c.load.tangential_force = 0;
    c.relaxation = contact::Relaxation{{{ratio, tau}}, contact::Relaxation::Bulk::proportional};
    return c;
}

inline contact::LoadStep at_depth(double d, double duration, double shift = 0) {
    contact::LoadStep step;
    step.normal = {contact::NormalControl::Kind::indentation, d};
    step.tangential[0] = {contact::TangentialControl::Kind::shift, shift};
    step.duration = duration;
    step.recurs = false;
    return step;
}

/// When the surface touches the body again that was pressed in by `depth` for long and then raised
/// at once. All displacements of a linear body without load shrink alike, whatever its shape: to
/// ratio/(1 + ratio) at once, then with the time (1 + ratio) tau of retardation. Under the body
/// they were d - h(r): it is touched where h = 0 first.
inline double time_of_return() {
    return (1 + ratio) * tau * std::log(ratio / (1 + ratio) * depth / raised);
}

/// Presses, relaxes, raises the body until nothing touches, and waits until the surface is back.
/// `same`: of the force beside that of a body at rest that is pressed by as much.
inline void expect_lost_and_back(contact::Model& model, double same) {
    using contact::StepRecord;
    constexpr double forever = std::numeric_limits<double>::infinity(), dt = .02;
    const double untouched = model.advance(at_depth(raised, forever)).normal_force;
    model.release();
    model.advance(at_depth(depth, 0));
    const double pressed = model.advance(at_depth(depth, forever)).normal_force;
    double shift = 1e-6;
    const StepRecord lost = model.advance(at_depth(raised, 0, shift));
    EXPECT_EQ(lost.normal_force, 0);
    EXPECT_EQ(lost.tangential_force[0], 0);
    EXPECT_EQ(lost.contact_area, 0);
    EXPECT_EQ(lost.shift[0], shift);
    EXPECT_EQ(lost.dissipation, 0);
    for (double t = dt; t < time_of_return() + dt; t += dt) {
        shift += 1e-6;
        const StepRecord r = model.advance(at_depth(raised, dt, shift));
        EXPECT_NEAR(r.shift[0], shift, 1e-18) << t;
        // Of the touching the mesh knows one cell: a hundredth of the way back.
        if (t < time_of_return() - dt) {
            EXPECT_EQ(r.normal_force, 0) << t;
        }
        if (t > time_of_return()) {
            EXPECT_GT(r.normal_force, 0) << t;
        }
    }
    const StepRecord back = model.advance(at_depth(raised, forever, shift));
    EXPECT_NEAR(back.normal_force / untouched, 1, same);
    EXPECT_LT(back.normal_force, pressed);
    EXPECT_TRUE(model.audit().passed());
}

/// No force acts on what nothing touches.
inline void expect_no_force_is_carried(contact::Model& model) {
    model.release();
    model.advance(at_depth(depth, std::numeric_limits<double>::infinity()));
    contact::LoadStep step = at_depth(raised, 0);
    step.tangential[0] = {contact::TangentialControl::Kind::force, 0};
    EXPECT_EQ(model.advance(step).normal_force, 0);
    step.tangential[0].value = .5;
    try {
        model.advance(step);
        ADD_FAILURE() << "carried";
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("force 0.5 N"), std::string::npos) << error.what();
    }
}

}  // namespace tricontact::lost_contact_test
