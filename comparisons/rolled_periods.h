#pragma once

#include <span>

#include "contact/history.h"

namespace tricontact::comparisons {

/// What one period of rolling shows of the contact's fate.
struct RolledPeriod {
    double increment = 0;           ///< of the shift, over U_max
    bool something_sticks = false;  ///< a point was in contact and stuck in all steps
};

/// The fate of a contact that rolls to and fro under a constant load, from all of its periods. It
/// ratchets if, for the last quarter of them (four at least), nothing has stuck throughout a period
/// and the increments, above `negligible`, have not fallen by 1 %; it shakes down if something
/// sticks and the increments have come below `negligible`. Undecided: roll on.
///
/// A point that never slips moves as its traction, which is bounded: it holds the indenter back, so
/// none may be left in a contact that ratchets. In uncoupled contact that is sufficient, too, once
/// the state repeats itself: without a net shift the load does no work, so that nothing slips.
/// Before that, all points may slip a little while the contact still comes to rest, hence the
/// increments. Just beyond the limit the shift passes a narrow place, where increments sink to the
/// order of the distance from the limit and rise again: that takes of the order of its power -1/2
/// in periods.
contact::State fate(std::span<const RolledPeriod> periods, double negligible);

}  // namespace tricontact::comparisons
