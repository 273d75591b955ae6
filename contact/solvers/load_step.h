#pragma once

#include <array>

#include "contact/base/bulk_state.h"
#include "contact/base/vector2.h"
#include "contact/solvers/centre_of_rotation.h"
#include "contact/solvers/control.h"

namespace tricontact::contact {

/// One quasi-static step; all values are those at its end.
struct LoadStep {
    double phase = 0;  ///< rolling periods since the start, 0 while loading
    Vector2 offset{};  ///< position of the indenter's lowest point over the substrate [m]
    NormalControl normal;
    std::array<TangentialControl, 2> tangential;  ///< x, y
    double duration = 0;   ///< [s], in which strains change linearly; infinite: all relaxes
    bool friction = true;  ///< false: the surface slides freely under the indenter in this step
    double rotation = 0;   ///< twist of the indenter since the start, from x towards y [rad]
    CentreOfRotation centre = {};
    BulkState bulk = {};  ///< of the substrate; the shift is relative to its point at x = y = 0
    bool recurs = true;   ///< a step at this phase of the period comes again and again
    /// All loads and motions change in proportion from the step before: what has moved before a
    /// point is met on the way is no slip. Else points are carried along by all of a step, an error
    /// of the first order in the steps.
    bool in_proportion = false;
};

}  // namespace tricontact::contact
