#pragma once

#include "contact/compliances/compliance.h"
#include "contact/surface.h"

namespace tricontact::contact {

/// The whole surface from its half with y >= 0, of nodes: x and normal components even in y, y
/// components odd. Points at y = 0 are not doubled.
Surface mirrored(Surface half);
/// The same of a field on a grid of `n_x` columns.
std::vector<double> mirrored_rows(const std::vector<double>& half, int n_x, bool is_odd);
std::vector<ContactState> mirrored_rows(const std::vector<ContactState>& half, int n_x);
/// The same of states at points, in the same order.
std::vector<ContactState> mirrored(const std::vector<ContactState>& half,
                                   const ContactPoints& points);

}  // namespace tricontact::contact
