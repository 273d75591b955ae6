// The normal and tangential contact of any body, by models: half-space or layer.
#include <fmt/format.h>

#include <cmath>

#include "experiments/assumptions/rolling_parts.h"

namespace tricontact::experiments {

namespace {

constexpr const char* half_space_runs = "boundary elements on the half-space";
constexpr const char* layer_runs = "boundary elements on the layer, uncoupled";

/// A quantity of both contacts.
struct BodyQuantity {
    const char *name, *symbol, *unit, *beside;
    Estimate BodyContact::*of;
};
const BodyQuantity body_quantities[] = {
    {"indentation", "d", "m", "Indentation is", &BodyContact::indentation},
    {"contact_radius", "a", "m", "the contact radius", &BodyContact::contact_radius},
    {"peak_pressure", "p_0", "Pa", "the peak pressure", &BodyContact::peak_pressure},
    {"static_shift", "U_stat", "m", "the static shift", &BodyContact::static_shift}};

Calculation number_of(const BodyQuantity& q, const std::string& name, const Estimate& value,
                      const char* runs) {
    return calculate(name, q.symbol, "a run of the rig's body", runs, q.unit,
                     {{q.symbol, value, q.unit}}, [](const auto& x) { return x.front(); });
}

std::string sentences(const BodyContacts& body) {
    std::string text;
    for (const BodyQuantity& q : body_quantities) {
        const double ratio = (body.layer.*q.of).value / (body.half_space.*q.of).value;
        if (std::isnan(ratio)) continue;
        text += fmt::format("{}{} {} {} the half-space's", text.empty() ? "" : ", ", q.beside,
                            percent_text(std::abs(ratio - 1)), ratio < 1 ? "below" : "above");
    }
    return text + '.';
}

}  // namespace

Assumption half_space_of_body(const Rig& rig) {
    using enum Criterion::Relation;
    const BodyContacts& body = *rig.body;
    Assumption a{.name = "half_space",
                 .title = "Half-space",
                 .claim = "The substrate is a half-space",
                 .consequence = sentences(body)};
    for (const BodyQuantity& q : body_quantities) {
        if (std::isnan((body.layer.*q.of).value)) continue;
        const std::string name = q.name;
        a.criteria.push_back(
            {relative_difference(
                 name + "_difference", fmt::format("|{0} layer/{0} half-space - 1|", q.symbol),
                 "runs of the rig's body", "boundary elements",
                 {std::string(q.symbol) + " layer", body.layer.*q.of, q.unit},
                 {std::string(q.symbol) + " half-space", body.half_space.*q.of, q.unit}),
             at_most, accepted_difference, accepted_reason});
        a.background.push_back(number_of(q, name, body.half_space.*q.of, half_space_runs));
        a.background.push_back(number_of(q, "layer_" + name, body.layer.*q.of, layer_runs));
    }
    return a;
}

}  // namespace tricontact::experiments
