#include "io/case/case_checks.h"
#include "io/case/case_keys.h"

namespace tricontact::io {

namespace {

using contact::Case;
using contact::Friction;

void check_law(const Friction& friction, const Document& document) {
    if (friction.pressure_exponent && !friction.coefficient)
        refuse(document, "friction.pressure_exponent",
               "no part of the friction grows with the pressure", "add friction.coefficient");
    if (friction.pressure_exponent && *friction.pressure_exponent == 1)
        refuse(document, "friction.pressure_exponent", "is Coulomb's law, without a pressure",
               "leave it out with friction.reference_pressure");
    if (friction.strength_limit && *friction.strength_limit <= friction.shear_strength.value_or(0))
        refuse(document, "friction.strength_limit",
               "is not above friction.shear_strength = " + rounded(*friction.shear_strength) +
                   " Pa: the pressure would have no say",
               "leave it out with friction.coefficient, or enlarge it");
}

/// What knows where a point lies on the substrate.
void check_map(const Case& c, const Document& document) {
    const std::string key = "friction.map";
    if (c.tractive_rolling)
        refuse(document, key, "rolling on meets no steady state where friction varies",
               "leave it out, or roll to and fro by [rolling]");
    if (c.law != Case::Law::linear)
        refuse(document, key, "at finite strains friction is the same all over",
               "leave it out, or set substrate.material to \"linear\"");
    for (const std::string& model : c.models)
        if (contact::model_kind(model).is_on_line())
            refuse(document, key, "the springs of " + model + " stand for all directions",
                   "leave out " + model + ", or leave out friction.map");
}

}  // namespace

void check_friction(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    if (!friction.coefficient && !friction.shear_strength)
        refuse_missing(*find_key("friction.coefficient"), document, case_key_list());
    check_law(friction, document);
    if (friction.map) check_map(c, document);
}

}  // namespace tricontact::io
