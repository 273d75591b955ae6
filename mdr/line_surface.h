#pragma once

#include <vector>

#include "contact/surface.h"
#include "mdr/even_load.h"

namespace tricontact::mdr {

/// A picture needs no more points; their transforms cost points times pieces.
inline constexpr int most_surface_points = 500, most_surface_pieces = 250;

/// Gives every field of a surface in line layout its length, zero; all open. `slip_path` and
/// `friction_work` stay empty, since springs are no points of the surface and have no area: before
/// rolling, a point at r slips by 2/pi ∫_0^r s(x)/sqrt(r^2 - x^2) dx of the springs' slips s, a
/// mean over parts of either sign (Popov and Hess 2015), from which no sum of |s| gives its path;
/// once the contact has rolled, no radius belongs to a spring.
void resize_fields(contact::Surface& surface);

/// What springs or elements on a line show, one value each.
struct LineFields {
    PointRow row{};
    double position = 0;                                   ///< of the indenter [m]
    double friction_coefficient = 0;                       ///< mu [-]
    std::vector<double> normal_load{}, tangential_load{};  ///< [N/m]
    std::vector<double> displacement_x{}, displacement_z{}, gap{}, slip_x{};  ///< [m]
    std::vector<contact::ContactState> contact_state{};
};

/// Line layout, thinned out; tractions transformed back from the loads' even parts.
contact::Surface make_line_surface(const LineFields& fields);

}  // namespace tricontact::mdr
