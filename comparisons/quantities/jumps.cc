#include <algorithm>

#include "comparisons/quantities/quantities.h"

namespace tricontact::comparisons::quantities {

namespace {

constexpr const char* where_it_remembers =
    "of friction that changes with the way of slip ([friction.weakening], interface.hardening)";

}  // namespace

constinit const Quantity released_energy{
    .key = "released_energy_J",
    .symbol = "E_free",
    .unit = "J",
    .name = "energy set free in the step of most",
    .meaning =
        "What the tractions worked along the slip beyond what friction took, in the step where it "
        "was most: of a smooth slide it falls with the length of the steps, of a jump it stays.",
    .defined = where_it_remembers,
    .of = [](const Subject& s) -> QuantityValue {
        if (!s.c.friction.remembers()) return {};
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
        if (!s.c.friction.remembers()) return {};
        int found = 0;
        for (const auto& step : s.history.steps) found += step.may_differ;
        return found;
    },
    .part = Part::end_of_run};

List of_jumps() {
    return {&released_energy, &steps_of_other_states};
}

}  // namespace tricontact::comparisons::quantities
