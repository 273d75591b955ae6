#pragma once

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

}  // namespace tricontact::contact
