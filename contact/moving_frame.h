#pragma once

#include <string>

#include "contact/substrate.h"

namespace tricontact::contact {

/// Throws InputError, `model` its subject, unless the points form a grid on both sides of the path
/// with an edge.
void check_rolls_on(const std::string& model, const ContactPoints& points);

/// The frame of coordinates moves on along x by one cell of the grid: what was one cell ahead is
/// here now. What enters at the leading edge is like the cell behind it, which is to be far from
/// the contact.
void carry(const ContactPoints& grid, std::vector<double>& field);
void carry(const ContactPoints& grid, SurfaceField& field);

}  // namespace tricontact::contact
