#pragma once

#include <string>

#include "contact/surface.h"

namespace tricontact::animation {

/// All of a regular file. Throws contact::InputError.
std::string content_of(const std::string& path);

/// A surface as io::vtk_file wrote it (.vti, .vtp, .vtu): tractions, gap, displacement and state,
/// on a grid, a line, or nodes whose positions alone are known. Throws contact::InputError.
contact::Surface read_surface(const std::string& path);

}  // namespace tricontact::animation
