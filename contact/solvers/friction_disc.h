#pragma once

#include "contact/vector2.h"

namespace tricontact::contact {

/// Point of the edge of the disc of radius `bound` (Coulomb's friction disc) in the direction of
/// `t`, which is not zero.
inline Vector2 onto_edge(const Vector2& t, double bound) {
    const double factor = bound / norm(t);
    return {t[0] * factor, t[1] * factor};
}

/// Nearest point to `t` in that disc.
inline Vector2 project_on_disc(const Vector2& t, double bound) {
    return norm(t) <= bound ? t : onto_edge(t, bound);
}

}  // namespace tricontact::contact
