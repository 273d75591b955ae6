#include <cmath>

#include "contact/heat.h"
#include "io/case/case_checks.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::HalfSpaceScales;
using contact::ThermalBody;

void check_heat_models(const Case& c, const std::string& key, const Document& document) {
    for (const std::string& model : c.models)
        if (contact::model_kind(model).is_on_line())
            refuse(document, key, "the springs of " + model + " know no points that slip and heat",
                   "leave out " + model + ", or leave out [indenter.heat] and [substrate.heat]");
}

/// Heat flows into the depth alone, and no further than the material that is stated.
void check_heat_flow(const Case& c, const ThermalBody& body, const std::string& name,
                     const HalfSpaceScales& scales, const Document& document) {
    const double v = c.tractive_rolling->speed, a = scales.half_widths[0];
    const double peclet = body.peclet(a, v);
    const std::string key = name + ".heat.conductivity";
    if (peclet < contact::least_peclet)
        refuse(document, key,
               "Pe = v a/(2 kappa) = " + rounded(peclet) + " is below " +
                   rounded(contact::least_peclet) +
                   ": heat does not flow into the depth alone, as is assumed",
               "roll faster than " + rounded(v * contact::least_peclet / peclet) +
                   " m/s, or leave out [indenter.heat] and [substrate.heat]");
    const double depth = contact::heated_depth * std::sqrt(body.diffusivity() * 2 * a / v);
    if (name != "substrate" || !c.layer.thickness || *c.layer.thickness >= depth) return;
    for (const std::string& model : c.models)
        if (contact::model_kind(model).is_layer())
            refuse(document, key,
                   "heat flows " + rounded(depth) + " m deep, through the layer of " +
                       rounded(*c.layer.thickness) + " m that " + model +
                       " has: what lies below is not known",
                   "roll faster, or leave out [indenter.heat] and [substrate.heat]");
}

void check_friction_by_temperature(const Case& c, const Document& document) {
    const auto& law = c.friction.temperature;
    if (!law) return;
    const std::string key = "friction.temperature.change";
    if (!c.kept.find<contact::ContactHeat>())
        refuse(document, key, "no temperatures are computed",
               "give [indenter.heat] and [substrate.heat], or leave out [friction.temperature]");
    if (!c.friction.is_coulomb_at_rest() || c.friction.rate)
        refuse(document, key, "only Coulomb's law changes with the temperature",
               "give friction.coefficient alone beside [friction.temperature]");
    if (law->change == 0)
        refuse(document, key, "changes nothing", "leave out [friction.temperature]");
    if (*c.friction.coefficient + law->change <= 0)
        refuse(document, key,
               "leaves " + rounded(*c.friction.coefficient + law->change) +
                   " of friction.coefficient = " + rounded(*c.friction.coefficient),
               "change it by less");
    if (!(law->from < law->to))
        refuse(document, "friction.temperature.to",
               "is not above friction.temperature.from = " + rounded(law->from) + " degC",
               "correct one of them");
    if (document.find("tractive_rolling.distance"))
        refuse(document, "tractive_rolling.distance",
               "friction that changes with the temperature is computed in the steady state alone, "
               "not on the way to it",
               "omit it");
}

}  // namespace

void check_heat(const Case& c, const HalfSpaceScales& scales, const Document& document) {
    check_friction_by_temperature(c, document);
    const contact::ContactHeat* heat = c.kept.find<contact::ContactHeat>();
    if (!heat) return;
    const std::string key = "substrate.heat.conductivity";
    if (!c.tractive_rolling)
        refuse(document, key, "temperatures are those of a contact that rolls on",
               "add [tractive_rolling], or leave out [indenter.heat] and [substrate.heat]");
    if (c.relaxation)
        refuse(document, key, "a relaxing substrate makes heat inside, which is not computed",
               "leave out [substrate.relaxation], or [indenter.heat] and [substrate.heat]");
    check_heat_models(c, key, document);
    check_heat_flow(c, heat->indenter, "indenter", scales, document);
    check_heat_flow(c, heat->substrate, "substrate", scales, document);
}

}  // namespace tricontact::io
