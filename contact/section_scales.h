#pragma once

#include "contact/half_space_scales.h"

namespace tricontact::contact {

/// A contact without closed forms here, which models of sections know: a pin in a hole, a punch
/// with a sharp edge or along y.
bool is_section_alone(const Case& c);

/// What ratios refer to there. No solutions: a pin has those of a line contact of the relative
/// radius, no wider than itself; a punch those of the half-space in frictionless contact, the peak
/// pressure being the mean. Sneddon (1965); along y the half width is that of Ciavarella, Hills and
/// Monno (1998), the depth that of a flat punch of that half width.
HalfSpaceScales section_scales(const Case& c);

}  // namespace tricontact::contact
