#pragma once

#include <vector>

#include "contact/compliances/compliance.h"
#include "fem/finite_strain/element_batch.h"

namespace tricontact::fem {

/// Areas that belong to the points of a contact displaced to `position` [m], on its surface [m^2].
std::vector<double> present_areas(const contact::ContactPoints& points,
                                  const std::vector<Vector3>& position);

}  // namespace tricontact::fem
