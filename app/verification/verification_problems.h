#pragma once

#include "app/models.h"
#include "comparisons/resolution/verification.h"

// Problems of `tricontact verify`. `brief`: on coarse levels, in seconds.

namespace tricontact::app {

/// mdr and bem where half-spaces have closed forms.
void verify_half_space(bool brief, const Say& say, comparisons::Verification& all);
/// mdr-layer and bem-layer beside exact frictionless contact with the layer.
void verify_layer(bool brief, const Say& say, comparisons::Verification& all);
/// bem and bem-layer under a cylinder: line contact and its oscillating rolling.
void verify_cylinder(bool brief, const Say& say, comparisons::Verification& all);
/// What bem finds below Hertz' contact.
void verify_subsurface(bool brief, const Say& say, comparisons::Verification& all);
/// mdr and bem on a relaxing half-space under a constant force.
void verify_creep(bool brief, const Say& say, comparisons::Verification& all);
/// mdr and bem in steady rolling beside closed forms and Kalker's table.
void verify_rolling(bool brief, const Say& say, comparisons::Verification& all);
/// bem pressed with friction, the pressure dragging the surface sideways.
void verify_friction_pressing(const Say& say, comparisons::Verification& all);
/// Shifts of bem and bem-layer beside those of other programs (comparisons/run/peer_shifts.h).
void verify_peer_shifts(const Say& say, comparisons::Verification& all);

/// Velocity Verlet beside closed forms and the event-driven integrator.
void verify_walking(const Say& say, comparisons::Verification& all);

/// fem under a cylinder on a layer.
void verify_fem_line(const Say& say, comparisons::Verification& all);
/// fem beside the same; no rows where the program has no finite elements.
void verify_fem(const Say& say, comparisons::Verification& all);

}  // namespace tricontact::app
