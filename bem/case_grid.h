#pragma once

#include "contact/case.h"
#include "contact/compliances/compliance.h"

// The cells on which a case is computed.
namespace tricontact::bem {

/// Sides of the cells and the place of the centre of one of them [m].
struct Cells {
    contact::Vector2 spacing, centre;
};

/// Cells of this side along x; their ratio and place are those of the case.
Cells cells_of(const contact::Case& c, double spacing);

// All throw contact::InputError where the grid would be too large.

/// Grid that covers `half_x` and `half_y` on either side of the origin, of what y = 0 mirrors on
/// one.
contact::ContactPoints make_grid(double half_x, double half_y, const Cells& cells, bool mirrored);
/// The same in x, over a body's whole length in y by cells of about this size, or by strips.
contact::ContactPoints make_long_grid(double half_x, const Cells& cells, double length,
                                      bool strips);
/// One period, a cell's centre at the origin. `adjustable`: by cells of this size at most, else it
/// has to be a whole number of them.
contact::ContactPoints period_grid(double period, double spacing, bool adjustable);

}  // namespace tricontact::bem
