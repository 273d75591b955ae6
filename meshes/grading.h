#pragma once

#include <vector>

namespace tricontact::meshes {

/// Edges that grow along a strip by a constant ratio.
struct Grading {
    int n = 0;             ///< number of elements; 0: no strip
    double ratio = 1;      ///< of an edge over the one before it [-]
    double length = 0;     ///< of the strip [m]
    double first() const;  ///< first edge [m]
    /// Distances of the n + 1 nodes from the strip's beginning [m]: 0 ... length, exactly.
    std::vector<double> nodes() const;
};

/// Fewest elements over `length` [m] whose first edge is `first` [m] and whose ratio is at most
/// `growth` (>= 1). A strip not longer than `first` gets one element, no length none. Where edges
/// would shrink to less than 1/growth of the one before (short strips): one element if it is at
/// most growth * first long, else that number of equal ones, a little shorter than `first`.
Grading grade(double length, double first, double growth);

/// Number of elements that grade() makes, as a double: it may be beyond any int.
double graded_count(double length, double first, double growth);

}  // namespace tricontact::meshes
