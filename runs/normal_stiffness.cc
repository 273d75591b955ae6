#include "runs/normal_stiffness.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "contact/base/error.h"
#include "contact/bodies/upper_plate.h"
#include "contact/load_path.h"
#include "contact/models/model_kind.h"

namespace tricontact::runs {

namespace {

constexpr contact::Case::Contact without_coupling{.coupling = false};
constexpr double of_curvature = .1;
// Of U_max: the edge slips, and F_T/U falls by a quarter of this (Mindlin).
constexpr double small_shift = 1e-3, of_edge = .25;

/// dF/dd = F/d times the slope of ln F over ln d, which is nearly straight: at the last of three
/// points on their parabola. On layers of 0.4 to 2 contact radii the parabola is off the exact
/// slope by a thirtieth to a tenth of what it changes of the line through the last two.
Stiffness stiffness_at_last(const std::array<contact::StepRecord, 3>& pressed) {
    std::array<double, 3> x{}, y{};
    for (int k = 0; k < 3; ++k) {
        x[k] = std::log(pressed[k].indentation);
        y[k] = std::log(pressed[k].normal_force);
    }
    const double first = (y[1] - y[0]) / (x[1] - x[0]), second = (y[2] - y[1]) / (x[2] - x[1]);
    const double bend = (second - first) * (x[2] - x[1]) / (x[2] - x[0]);
    const double secant = pressed[2].normal_force / pressed[2].indentation;
    return {secant * (second + bend), of_curvature * secant * std::abs(bend)};
}

/// The hardest normal load of the case, without friction, slow.
contact::LoadStep hardest_press(const contact::Case& c) {
    contact::LoadStep hardest;
    hardest.friction = false;
    hardest.duration = std::numeric_limits<double>::infinity();
    hardest.normal =
        c.prescribed_path ? c.prescribed_path->hardest_normal() : contact::press_step(c).normal;
    return hardest;
}

}  // namespace

Stiffness frictionless_stiffness(const contact::Case& c, contact::Model& model) {
    if (c.adhesion)
        throw contact::InputError(
            "adhesion.work: under attraction force and depth follow no power law, whose slope the "
            "stiffness is");
    // Nodes join the contact one by one: wider steps average over that.
    constexpr std::array shares{0.6, 0.8, 1.0};
    auto sibling = model.sibling(without_coupling);
    if (!sibling) sibling = model.sibling(c.contact);  // without friction it is the same
    contact::Model& fresh = sibling ? *sibling : model;
    if (!sibling) fresh.release();
    const contact::LoadStep hardest = hardest_press(c);
    std::array<contact::StepRecord, 3> pressed;
    for (int k = 0; k < 3; ++k) {
        contact::LoadStep step = hardest;
        step.normal.value *= shares[k];
        pressed[k] = fresh.advance(step);
        if (!(pressed[k].indentation > 0) || !(pressed[k].normal_force > 0))
            throw contact::InputError(
                fmt::format("at {} of the load the indentation is {:.3g} m under {:.3g} N: there "
                            "is no slope of "
                            "their logarithms; press harder",
                            shares[k], pressed[k].indentation, pressed[k].normal_force));
    }
    return stiffness_at_last(pressed);
}

std::optional<Stiffness> sticking_stiffness(const contact::Case& c, contact::Model& model) {
    using contact::ElasticBody;
    const bool is_held =
        contact::model_kind(model.name()).cut != contact::ModelKind::Cut::of_revolution &&
        !(c.indenter.body && (c.indenter.body->support == ElasticBody::Support::plates ||
                              c.indenter.body->is_loose()));
    if (!is_held) return {};
    const auto sibling = model.sibling(c.contact);
    contact::Model& fresh = sibling ? *sibling : model;
    fresh.release();
    contact::LoadStep step = hardest_press(c);
    fresh.advance(step);
    const double unit = fresh.scales().unit_shift;
    if (!(unit > 0)) return {};
    step.friction = true;
    step.tangential[0] = {contact::TangentialControl::Kind::shift, small_shift * unit};
    const contact::StepRecord moved = fresh.advance(step);  // by what a rig leaves of it
    const double stiffness = moved.tangential_force[0] / moved.shift[0];
    return Stiffness{stiffness, of_edge * small_shift * stiffness};
}

std::optional<contact::Scales> upper_contact(const contact::Case& c, const contact::Model& model) {
    if (!c.kept.find<contact::UpperPlate>()) return {};
    const auto pressed = model.sibling(c.contact);
    if (!pressed) return {};
    pressed->advance(hardest_press(c));
    return pressed->upper_scales();
}

}  // namespace tricontact::runs
