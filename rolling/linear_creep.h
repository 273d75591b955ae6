#pragma once

#include <array>
#include <vector>

#include "contact/compliances/compliance.h"

namespace tricontact::rolling {

/// Force and moment of friction on the substrate per small creepage, while the whole contact
/// sticks: Kalker's linear theory, whatever the bodies. Rows F_x, F_y [N], M_z [N m]; columns xi,
/// eta [-], phi [1/m].
using LinearCreep = std::array<std::array<double, 3>, 3>;

/// The contact are the points under pressure [Pa], centre at the origin of a grid whose edge they
/// do not reach; normal and tangential contact uncoupled. Traction is singular at the trailing
/// edge: creepages along and across are of the first order in the cell (see contact::spin_point for
/// spin). Throws contact::InputError for points that form no grid, contact::NotConverged.
LinearCreep linear_creep(const contact::Compliance& compliance,
                         const std::vector<double>& pressure);

}  // namespace tricontact::rolling
