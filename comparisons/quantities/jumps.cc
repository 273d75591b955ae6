#include <algorithm>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

constexpr const char* where_it_remembers =
    "of friction that changes with the way of slip ([friction.weakening], interface.hardening), "
    "and of [adhesion]";
constexpr const char* where_it_attracts = "of surfaces that attract each other, [adhesion]";

bool may_jump(const Subject& s) {
    return s.c.friction.remembers() || s.c.adhesion;
}

QuantityValue of_pull_off(const Subject& s, double contact::PullOff::*value) {
    return s.history.pull_off ? finite((*s.history.pull_off).*value) : QuantityValue();
}

}  // namespace

constinit const Quantity released_energy{
    .key = "released_energy_J",
    .symbol = "E_free",
    .unit = "J",
    .name = "energy set free in the step of most",
    .meaning =
        "What the tractions worked along the slip beyond what friction took, in the step where it "
        "was most: of a smooth slide it falls with the length of the steps, of a jump it stays. Of "
        "surfaces that attract each other what is lost as contact jumps in or lets go.",
    .defined = where_it_remembers,
    .of = [](const Subject& s) -> QuantityValue {
        if (!may_jump(s)) return {};
        double most = 0;
        for (const auto& step : s.history.steps) most = std::max(most, step.released_energy);
        return finite(most);
    },
    .part = Part::end_of_run};

constinit const Quantity steps_of_other_states{
    .key = "steps_of_other_states",
    .name = "steps that have another state, too",
    .meaning =
        "Steps whose loads another state of more slip is in equilibrium with as well, or none is "
        "known not to be. The state of least slip is followed.",
    .defined = where_it_remembers,
    .of = [](const Subject& s) -> QuantityValue {
        if (!may_jump(s)) return {};
        int found = 0;
        for (const auto& step : s.history.steps) found += step.may_differ;
        return found;
    },
    .part = Part::end_of_run};

constinit const Quantity pull_off_force{
    .key = "pull_off_force_N",
    .symbol = "F_off",
    .unit = "N",
    .name = "pull-off force",
    .meaning = "The largest tension that the contact holds when it is pulled slowly.",
    .defined = where_it_attracts,
    .source = "Johnson, Kendall and Roberts (1971)",
    .of = [](const Subject& s) { return of_pull_off(s, &contact::PullOff::force); },
    .part = Part::pressed,
    .is_refined = true,
    .is_plotted = true};

constinit const Quantity pull_off_radius{
    .key = "pull_off_radius_m",
    .symbol = "a_off",
    .unit = "m",
    .name = "contact radius at pull-off",
    .meaning = "Contact radius under the pull-off force, the least that a force leaves in contact.",
    .defined = where_it_attracts,
    .source = "Johnson, Kendall and Roberts (1971)",
    .of = [](const Subject& s) { return of_pull_off(s, &contact::PullOff::radius); },
    .part = Part::pressed,
    .is_refined = true};

constinit const Quantity pull_off_indentation{
    .key = "pull_off_indentation_m",
    .symbol = "d_off",
    .unit = "m",
    .name = "indentation at pull-off",
    .meaning =
        "Indentation under the pull-off force, negative: the tip hangs over the undeformed "
        "surface.",
    .defined = where_it_attracts,
    .source = "Johnson, Kendall and Roberts (1971)",
    .of = [](const Subject& s) { return of_pull_off(s, &contact::PullOff::indentation); },
    .part = Part::pressed,
    .is_refined = true};

constinit const Quantity last_indentation{
    .key = "last_indentation_m",
    .symbol = "d_last",
    .unit = "m",
    .name = "indentation of the last contact",
    .meaning = "Indentation at which the contact lets go where the depth is prescribed.",
    .defined = where_it_attracts,
    .source = "Johnson, Kendall and Roberts (1971)",
    .of = [](const Subject& s) { return of_pull_off(s, &contact::PullOff::last_indentation); },
    .part = Part::pressed,
    .is_refined = true};

List of_jumps() {
    return {&released_energy, &steps_of_other_states, &pull_off_force,
            &pull_off_radius, &pull_off_indentation,  &last_indentation};
}

}  // namespace tricontact::comparisons::quantities
