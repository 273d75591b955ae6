#pragma once

#include <map>
#include <string>
#include <vector>

#include "atlas/atlas.h"
#include "contact/case.h"

namespace tricontact::atlas {

// A case in the coordinates of the shipped maps.

/// The angle between two lines, in [0, pi/2], of an angle in any quadrant [rad].
double folded_angle(double angle);
/// Poisson's ratio of two half-spaces together: that of one body with their ratio of tangential to
/// normal compliance.
double common_poisson(const contact::Case& c);
/// What an exact sphere adds to the bars of maps of paraboloids, as a share; 0 for others.
double shape_error(const contact::Case& c);

/// The case of an atlas' runs at another Poisson's ratio, with which scales of Hertz change.
contact::Case case_of_runs(const Atlas& atlas, double poisson);

/// Of a load f beyond the limit of shakedown: its share of the way to full sliding, f = 1; negative
/// below the limit, where no atlas of ratcheting is.
double excess_of(double f, double limit);

/// The coordinates of a place in an atlas: the first of them given, the rest by their keys. Throws
/// OutsideDomain if a key that the atlas keeps has another value there; but the angle, which is
/// none of a contact at rest.
std::vector<double> coordinates_in(const Atlas& atlas, std::vector<double> first,
                                   const std::map<std::string, double>& rest);

}  // namespace tricontact::atlas
