#pragma once

#include "contact/surface.h"
#include "contact/vector2.h"

namespace tricontact::contact {

/// Slip of a point, as results tell it: 0 where it does not slip. What solvers leave there is their
/// residual, of any direction.
inline Vector2 told_slip(ContactState state, const Vector2& slip) {
    return state == ContactState::slip ? slip : Vector2{};
}

/// Frictional work of a step at a point [J/m^2]: never negative, as where it slips, by more than
/// ten times the solver's residual, traction and slip have one direction.
inline double frictional_work(ContactState state, const Vector2& traction, const Vector2& slip) {
    return dot(traction, told_slip(state, slip));
}

}  // namespace tricontact::contact
