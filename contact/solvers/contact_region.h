#pragma once

#include <vector>

#include "contact/bodies/indenter.h"
#include "contact/compliances/compliance.h"

namespace tricontact::contact {

/// Contact radius [m] of an about axisymmetric, smooth contact centred at `centre`, from the second
/// and fourth moments of the pressure: those of p = sqrt(1 - r^2/a^2) (c0 + c1 r^2/a^2), whatever
/// c1/c0. Moments gain from the cancelling errors of the points, where counting points is first
/// order only; the form is exact for Hertz, within 1e-5 for a layer with b > a and 0.25 % for
/// b = 0.7 a. What is no such pressure (a few points) is counted.
/// Of a contact with a line_length the half width, likewise, with s = x^2/a^2.
double contact_radius(const ContactPoints& points, const std::vector<double>& pressure,
                      const Vector2& centre);

/// Area of parts of the points [m^2].
double shared_area(const ContactPoints& points, const std::vector<double>& share);

/// Radius [m] of a disc as large as the points with pressure.
double counted_radius(const ContactPoints& points, const std::vector<double>& pressure);

/// The same of parts of the points [-]; of a contact with a line_length half the width.
double shared_radius(const ContactPoints& points, const std::vector<double>& share);

/// Height of the indenter, its lowest point at `offset`, over each contact point [m].
std::vector<double> heights_over(const ContactPoints& points, const Indenter& indenter,
                                 const Vector2& offset, int n_threads = 1);
/// The same into `height`, which has room for all points.
void set_heights(const ContactPoints& points, const Indenter& indenter, const Vector2& offset,
                 int n_threads, std::vector<double>& height);

/// Some point at the edge of the grid or element surface carries pressure: the contact may go on
/// outside. A periodic grid has no edge.
bool reaches_edge(const ContactPoints& points, const std::vector<double>& pressure);

}  // namespace tricontact::contact
