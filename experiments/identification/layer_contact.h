#pragma once

#include <string>

#include "contact/case.h"
#include "contact/solvers/control.h"
#include "experiments/identification/friction_values.h"
#include "theory/springs/sprung_contact.h"

namespace tricontact::experiments {

// A bonded layer under a rigid paraboloid, under any law of friction and any interface, by
// theory/springs/sprung_contact.h: what the layer's theory and mdr-layer come to, without their
// runs.

/// Under a law that is not Coulomb's, or on springs: what the tables of other runs do not hold.
bool is_beyond_coulomb(const contact::Case& rig);

/// What of the rig is not of that kind: "substrate.base: ..."; empty if it is.
std::string why_no_layer_contact(const contact::Case& rig);

/// Interpolated between contacts that are computed when first needed, 1e-5. Throws
/// contact::InputError where the contact is wider than eight times the thickness.
Pressed layer_press(const contact::Case& rig, const contact::NormalControl& control);
theory::SprungContact layer_contact(const contact::Case& rig, double normal_force);

}  // namespace tricontact::experiments
