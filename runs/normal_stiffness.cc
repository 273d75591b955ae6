#include "runs/normal_stiffness.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "contact/base/error.h"
#include "contact/load_path.h"

namespace tricontact::runs {

namespace {

constexpr contact::Case::Contact without_coupling{.coupling = false};
constexpr double of_curvature = .1;

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

}  // namespace

Stiffness frictionless_stiffness(const contact::Case& c, contact::Model& model) {
    // Nodes join the contact one by one: wider steps average over that.
    constexpr std::array shares{0.6, 0.8, 1.0};
    auto sibling = model.sibling(without_coupling);
    if (!sibling) sibling = model.sibling(c.contact);  // without friction it is the same
    contact::Model& fresh = sibling ? *sibling : model;
    if (!sibling) fresh.release();
    contact::LoadStep hardest;
    hardest.friction = false;
    hardest.duration = std::numeric_limits<double>::infinity();
    hardest.normal =
        c.prescribed_path ? c.prescribed_path->hardest_normal() : contact::press_step(c).normal;
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

}  // namespace tricontact::runs
