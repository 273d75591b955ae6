#pragma once

#include <memory>
#include <string>

#include "contact/friction/friction_map.h"

namespace tricontact::io {

/// Reads a table `x [mm], factor` (stripes) or `x [mm], y [mm], factor`, its rows in any order, one
/// for each pair of an x and a y. Throws contact::InputError.
std::shared_ptr<const contact::FrictionMap> read_friction_map(const std::string& file);

}  // namespace tricontact::io
