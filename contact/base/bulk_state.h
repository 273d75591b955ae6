#pragma once

#include <array>

#include "contact/base/vector2.h"

namespace tricontact::contact {

/// A uniform stress along x in all of the substrate, tension positive, and what it strains: a
/// half-space between free sides in uniaxial stress, under a line contact in plane strain.
struct BulkState {
    Vector2 stress{};                ///< XX, YY [Pa]
    std::array<double, 3> strain{};  ///< XX, YY, ZZ [-]
};

}  // namespace tricontact::contact
