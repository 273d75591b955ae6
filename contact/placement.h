#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/solvers/compliance.h"

namespace tricontact::contact {

/// Height of the indenter, its lowest point at `offset`, over each contact point [m].
std::vector<double> heights_over(const ContactPoints& points, const Indenter& indenter,
                                 const Vector2& offset);

/// Some point at the edge of the grid or element surface carries pressure: the contact may go on
/// outside. A periodic grid has no edge.
bool reaches_edge(const ContactPoints& points, const std::vector<double>& pressure);

}  // namespace tricontact::contact
