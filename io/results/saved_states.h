#pragma once

#include <string>

#include "contact/surface.h"

namespace tricontact::io {

/// See read_surface_file: a state of `.ex2`.
contact::Surface read_state(const std::string& path, int state);

}  // namespace tricontact::io
