#pragma once

#include "contact/substrate.h"

namespace tricontact::contact {

/// The frame of coordinates moves on along x by one cell of the grid: what was one cell ahead is
/// here now. What enters at the leading edge is like the cell behind it, which is to be far from
/// the contact.
void carry(const ContactPoints& grid, std::vector<double>& field);
void carry(const ContactPoints& grid, SurfaceField& field);

}  // namespace tricontact::contact
