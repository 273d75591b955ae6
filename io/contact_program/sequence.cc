#include "io/contact_program/sequence.h"

#include <fmt/format.h>

#include "contact/error.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;

[[noreturn]] void refuse_key(const char* key, const char* rule, const char* remedy) {
    throw contact::InputError(fmt::format("{}: {}; {}", key, rule, remedy));
}

/// What the half-space and layer of CONTACT do not do.
void check_bodies(const Case& c, bool is_coupled) {
    if (c.relaxation)
        refuse_key("substrate.relaxation", "CONTACT takes relaxing bodies in steady rolling alone",
                   "such a case cannot be written for it");
    if (c.bem.period) refuse_key("bem.period", "CONTACT knows no periodic contact", "omit it");
    if (c.contact.kinematics != Case::Kinematics::linear)
        refuse_key("contact.kinematics", "CONTACT's kinematics are linear", "take \"linear\"");
    if (is_coupled && !c.contact.coupling)
        refuse_key("contact.coupling", "CONTACT always couples such bodies", "omit it");
    const auto out_of_range = [](const contact::Material& m) { return m.poisson < 0; };
    if (out_of_range(c.substrate) || (c.indenter.material && out_of_range(*c.indenter.material)))
        refuse_key("poisson", "CONTACT takes Poisson's ratios from 0 to 1/2",
                   "such a material cannot be written for it");
}

/// F_T is over mu F_N there; what F_N will be under a prescribed depth only a run knows.
void check_loads(const Case& c) {
    if (c.tractive_rolling)
        refuse_key("tractive_rolling", "rolling on is not written as shifts in fixed coordinates",
                   "give [rolling], or none");
    if (c.rolling && c.rolling->amplitude_reference == Case::AmplitudeReference::model)
        refuse_key("rolling.amplitude_reference", "the model's radius is known by a run alone",
                   "take \"hertz\", or give rolling.amplitude");
    if (!c.load.indentation) return;
    if (c.rolling)
        refuse_key("load.indentation", "CONTACT takes F_T over the F_N of each step",
                   "give load.normal_force where the indenter rolls");
    if (c.load.tangential_force)
        refuse_key("load.tangential_force", "CONTACT takes F_T over F_N, which d does not tell",
                   "give load.tangential_ratio");
}

SequenceStep step_of(const LoadStep& step, double friction_coefficient) {
    // Under a prescribed depth the path was made for F_N = 1 N.
    const double normal = step.normal.kind == NormalControl::Kind::force ? step.normal.value : 1;
    return {step.friction, step.normal, step.tangential[0].value / (friction_coefficient * normal),
            step.offset};
}

}  // namespace

std::vector<SequenceStep> sequence_of(const Case& c, bool is_coupled) {
    check_bodies(c, is_coupled);
    check_loads(c);
    const double radius = c.rolling ? half_space_scales(c).contact_radius : 0;
    const auto path = make_load_path(c, c.load.normal_force.value_or(1), radius);

    std::vector<SequenceStep> steps;
    const auto append = [&](const std::vector<LoadStep>& part) {
        for (const LoadStep& step : part) steps.push_back(step_of(step, c.friction_coefficient));
    };
    if (is_coupled)
        append(path.pressing);
    else
        steps.push_back({.tangential = false, .normal = press_step(c).normal});
    append(path.loading);
    for (int n = 0; n < path.max_periods; ++n) append(path.period);
    return steps;
}

}  // namespace tricontact::io
