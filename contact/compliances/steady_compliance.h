#pragma once

#include <span>

#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// The compliance of a body that remembers and moves on steadily below the contact, along -x: what
/// has settled in the frame that stays with the contact. It depends on relative positions alone, as
/// an elastic one, but creeps behind a load and not ahead of it: it is not self-adjoint. Its
/// symmetric part is positive definite, the other one dissipates: t' du/dx <= 0 for all t.
class SteadyCompliance : public Compliance {
  public:
    /// An approximation of the inverse of `normal`; its scale is free.
    virtual void precondition_normal(std::span<const double> r, std::span<double> z) const = 0;
};

}  // namespace tricontact::contact
