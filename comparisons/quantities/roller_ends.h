#pragma once

#include <optional>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::comparisons {

/// The upright contact of a roller on one line across it.
struct RollerSection {
    double distance = 0;    ///< from the nearer end [m], >= 0
    double half_width = 0;  ///< of the contact [m]
    double pressure = 0;    ///< in its middle, p(0, y) [Pa]
};

/// Sections in contact of the half y >= 0, from the end inwards, one per row of points. Edges lie
/// between the points where the gap's power 2/3, linear in the distance from them, vanishes.
std::vector<RollerSection> roller_sections(const contact::Surface& surface, double length);

/// What the ends do to the contact's outline.
struct RollerEnds {
    double middle_half_width = 0;  ///< at half length [m]
    double widest_ratio = 0;       ///< largest half width over that in the middle
    /// How far from the end [m] the half width exceeds that in the middle by more than 1 %: where a
    /// dog-bone's knuckle begins; zero where it nowhere does.
    double knuckle = 0;
    /// How far from the end [m] it differs by more than 1 % either way.
    double reach = 0;
};

/// In the last upright state; empty unless the indenter is a roller, and without snapshots.
std::optional<RollerEnds> roller_ends(const contact::Case& c, const contact::History& history);

}  // namespace tricontact::comparisons
