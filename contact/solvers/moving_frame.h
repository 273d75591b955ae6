#pragma once

#include <string>

#include "contact/substrates/substrate.h"

namespace tricontact::contact {

/// Where a step of one cell evaluates what an indenter that turns slides by: this part of a cell
/// ahead of the cell's centre. Displacements change between (x + h) and x, their rate belongs to
/// x + h/2; but cells of constant traction whose slip is prescribed there act as a contact whose
/// edges are delta h farther out, all of it h/4 farther ahead. Of a strip that sticks, the force of
/// a spin is then that of slip prescribed by 1/4 - delta of a cell ahead, to the second order in h:
///   delta = 1/pi int_0^pi -ln rho(q)/(4 sin^2(q/2)) dq,
///   rho(q) = 4 sin^2(q/2) sum_m (-1)^m sgn(m + 0) (q + 2 pi m)^-2,
/// rho the symbol of the cells over that of line loads (docs/rolling.md derives it).
inline constexpr double spin_point = 0.174653;

/// Throws InputError, `model` its subject, unless the points form a grid on both sides of the path
/// with an edge.
void check_rolls_on(const std::string& model, const ContactPoints& points);

/// The frame of coordinates moves on along x by one cell of the grid: what was one cell ahead is
/// here now. What enters at the leading edge is like the cell behind it, which is to be far from
/// the contact.
void carry(const ContactPoints& grid, std::vector<double>& field);
void carry(const ContactPoints& grid, SurfaceField& field);

}  // namespace tricontact::contact
