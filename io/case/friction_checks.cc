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

}  // namespace

void check_friction(const Case& c, const Document& document) {
    const Friction& friction = c.friction;
    if (!friction.coefficient && !friction.shear_strength)
        refuse_missing(*find_key("friction.coefficient"), document, case_key_list());
    check_law(friction, document);
}

}  // namespace tricontact::io
