#pragma once

#include "contact/half_space_scales.h"
#include "contact/history.h"

namespace tricontact::contact {

/// A model of a body between two plates that are not alike: what it knows of the upper contact,
/// which carries the same force as the lower one, the contact of the model.
class OpposedContact {
  public:
    virtual ~OpposedContact() = default;

    /// Of the present state; the indentation is that of the upper plate.
    virtual Scales upper_scales() const = 0;
};

/// A contact without closed forms here, which models of sections know: a pin in a hole, a punch
/// with a sharp edge or along y.
bool is_section_alone(const Case& c);

/// What ratios refer to there. No solutions: a pin has those of a line contact of the relative
/// radius, no wider than itself; a punch those of the half-space in frictionless contact, the peak
/// pressure being the mean. Sneddon (1965); along y the half width is that of Ciavarella, Hills and
/// Monno (1998), the depth that of a flat punch of that half width.
HalfSpaceScales section_scales(const Case& c);

}  // namespace tricontact::contact
