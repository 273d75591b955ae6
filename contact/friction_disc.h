#pragma once

#include "contact/vector2.h"

namespace tricontact::contact {

/// Nearest point to `t` in the disc of radius `bound` (Coulomb's friction disc).
inline Vector2 project_on_disc(const Vector2& t, double bound) {
    const double size = norm(t);
    if (size <= bound) return t;
    return {t[0] * (bound / size), t[1] * (bound / size)};
}

}  // namespace tricontact::contact
