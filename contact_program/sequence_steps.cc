#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/heat.h"
#include "contact/rig_stiffness.h"
#include "contact/wearing_contact.h"
#include "contact_program/sequence.h"
#include "io/case/case_input.h"
#include "io/keys/messages.h"

namespace tricontact::contact_program {

namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::TangentialControl;
using contact::Vector2;

/// Whether nothing acts or moves along y, so that neither force nor shift arises there.
bool is_symmetric_in_y(const Case& c) {
    const auto& rolls_on = c.tractive_rolling;
    const bool across = rolls_on && (rolls_on->spin != 0 || rolls_on->lateral_creepage);
    return contact::is_mirror_symmetric(c) && !across && !c.indenter.roughness &&
           c.indenter.shape != Case::Shape::height_map;
}

/// What the half-space and layer of CONTACT do not do.
void check_bodies(const Case& c, bool is_coupled) {
    if (c.relaxation)
        io::fail("substrate.relaxation", "",
                 "CONTACT takes relaxing bodies in steady rolling alone",
                 "such a case cannot be written for it");
    if (c.period) io::fail("bem.period", "", "CONTACT has no periodic contacts", "omit it");
    if (is_coupled && !c.contact.coupling)
        io::fail("contact.coupling", "", "CONTACT always couples such bodies", "omit it");
    if (c.has_rigid_substrate)
        io::fail("substrate.rigid", "", "CONTACT takes a rigid upper body, no rigid lower one",
                 "give the elastic body as the substrate");
    const auto out_of_range = [](const contact::Material& m) { return m.poisson < 0; };
    if (out_of_range(c.substrate) || (c.indenter.material && out_of_range(*c.indenter.material)))
        io::fail("poisson", "", "CONTACT takes Poisson's ratios from 0 to 1/2",
                 "such a material cannot be written for it");
}

using Kind = TangentialControl::Kind;

std::string path_key(const Case& c) {
    if (c.kept.find<io::OscillationInput>()) return io::path_words(c);
    return c.of<io::PathInput>().file ? "path.file" : "path.table";
}

/// Forces are over mu F_N there, and of x and y the force of x comes first.
void check_path(const Case& c) {
    if (c.of<contact::RigStiffness>().yields())
        io::fail("rig", "", "CONTACT has no rig in series with the contact",
                 "omit its stiffnesses, and give shifts that the contact feels");
    const contact::PrescribedPath& path = *c.prescribed_path;
    const auto is_forced = [&](int axis) {
        return path.rows.front().tangential[axis].kind == Kind::force;
    };
    const auto is_loaded = [&](int axis) {
        return std::ranges::any_of(
            path.rows, [&](const auto& row) { return row.tangential[axis].value != 0; });
    };
    const bool by_depth = path.rows.front().normal.kind == NormalControl::Kind::indentation;
    for (const int axis : {0, 1})
        if (by_depth && is_forced(axis) && is_loaded(axis))
            io::fail(path_key(c), "", "CONTACT takes F_T over F_N, which d does not determine",
                     "give normal_force, or shifts");
    // What needs no force along y by symmetry needs no shift either.
    if (!is_forced(0) && is_forced(1) && !is_symmetric_in_y(c))
        io::fail(path_key(c), "",
                 "CONTACT prescribes no shift along x beside a force along y (F = 0, 1, 2)",
                 "turn the case by 90 degrees, or give shift_y");
}

void check_rolling_on(const Case& c) {
    const auto& rolls_on = *c.tractive_rolling;
    if (rolls_on.longitudinal_creepage && !rolls_on.lateral_creepage && !is_symmetric_in_y(c))
        io::fail("tractive_rolling.lateral_creepage", "",
                 "CONTACT prescribes no creepage along x beside a force along y (F = 0, 1, 2)",
                 "give it");
    if (c.load.indentation && c.load.tangential_force.value_or(0) != 0)
        io::fail("load.tangential_force", "",
                 "CONTACT takes F_T over F_N, which d does not determine",
                 "give load.tangential_ratio");
}

/// F_T is over mu F_N there; what F_N will be under a prescribed depth only a run knows.
void check_loads(const Case& c) {
    if (c.kept.find<contact::Wear>()) contact::refuse_wear(c);
    if (c.prescribed_path) return check_path(c);
    if (c.tractive_rolling) return check_rolling_on(c);
    if (c.rolling && c.rolling->amplitude_reference == Case::AmplitudeReference::model)
        io::fail("rolling.amplitude_reference", "", "the model's radius is known by a run alone",
                 "take \"hertz\", or give rolling.amplitude");
    if (c.load.is_by_limit())
        io::fail(c.load.limit_key(), "", "the model's limit is known by a run alone",
                 "give load.tangential_ratio");
    if (!c.load.indentation) return;
    if (c.rolling)
        io::fail("load.indentation", "", "CONTACT takes F_T over the F_N of each step",
                 "give load.normal_force where the indenter rolls");
    if (c.load.tangential_force)
        io::fail("load.tangential_force", "",
                 "CONTACT takes F_T over F_N, which d does not determine",
                 "give load.tangential_ratio");
}

/// Steps as they are prescribed there: shifts and twist one by one.
struct StepWriter {
    explicit StepWriter(const Case& c)
        : case_(c), lowest_(c.make_indenter()->lowest_point()), symmetric_(is_symmetric_in_y(c)) {}

    std::vector<SequenceStep> steps = {};

    /// In one step without friction.
    void press(const LoadStep& pressed) {
        steps.push_back({.tangential = false, .normal = pressed.normal, .offset = pressed.offset});
    }

    /// From rest by cells of this size, then the steady state.
    void roll_on(double cell) {
        const Case::TractiveRolling& given = *case_.tractive_rolling;
        SequenceStep step{.normal = press_step(case_).normal, .centre = lowest_};
        if (given.longitudinal_creepage)
            step.along[0] = {Kind::shift, 0};
        else
            step.along[0].value = force_ratio();
        if (given.lateral_creepage || (symmetric_ && given.longitudinal_creepage))
            step.along[1] = {Kind::shift, 0};
        // Friction that changes with slip or temperature is computed in the steady state alone.
        if (!case_.friction.rate && !case_.friction.temperature) steps.push_back(step);
        if (given.longitudinal_creepage) step.along[0].value = *given.longitudinal_creepage;
        if (given.lateral_creepage) step.along[1].value = *given.lateral_creepage;
        step.rotation = given.spin;
        step.motion = SequenceStep::Motion::rolls_on;
        const double way = given.distance * half_space_scales(case_).contact_radius;
        steps.insert(steps.end(), std::lround(way / cell), step);
        step.motion = SequenceStep::Motion::steady;
        steps.push_back(step);
    }

    void append(const std::vector<LoadStep>& part) {
        for (const LoadStep& step : part) {
            SequenceStep next{.tangential = step.friction,
                              .normal = step.normal,
                              .along = {control(step, 0), control(step, 1)},
                              .offset = step.offset,
                              .rotation = step.rotation - rotation_,
                              .centre = step.centre.at(step.offset, lowest_)};
            if (symmetric_ && !next.is_forced(0)) next.along[1].kind = Kind::shift;
            rotation_ = step.rotation;
            steps.push_back(next);
        }
    }

  private:
    double force_ratio() const {
        const auto& load = case_.load;
        return load.tangential_ratio
                   ? *load.tangential_ratio
                   : load.tangential_force.value_or(0) /
                         (case_.friction_coefficient() * load.normal_force.value_or(1));
    }

    TangentialControl control(const LoadStep& step, int axis) {
        const TangentialControl& given = step.tangential[axis];
        if (given.kind == Kind::shift)
            return {Kind::shift, given.value - std::exchange(shift_[axis], given.value)};
        // Under a prescribed depth the path was made for F_N = 1 N.
        const bool force = step.normal.kind == NormalControl::Kind::force;
        return {Kind::ratio,
                given.value / (case_.friction_coefficient() * (force ? step.normal.value : 1))};
    }

    const Case& case_;
    Vector2 lowest_;
    bool symmetric_;
    Vector2 shift_{};  // prescribed before [m]
    double rotation_ = 0;
};

}  // namespace

std::vector<SequenceStep> sequence_of(const Case& c, bool is_coupled) {
    check_bodies(c, is_coupled);
    check_loads(c);
    StepWriter steps(c);
    if (c.tractive_rolling) {
        steps.roll_on(contact::cell_side(c));
        return steps.steps;
    }
    const double radius = c.rolling ? half_space_scales(c).contact_radius : 0;
    const auto path = make_load_path(c, c.load.normal_force.value_or(1), radius);

    const bool loaded = c.prescribed_path && c.prescribed_path->loads_first_row();
    if (is_coupled || loaded)
        steps.append(path.pressing);
    else if (!path.pressing.empty())
        steps.press(path.pressing.back());
    steps.append(path.loading);
    for (int n = 0; n < path.max_periods; ++n) steps.append(path.period);
    return steps.steps;
}

}  // namespace tricontact::contact_program
