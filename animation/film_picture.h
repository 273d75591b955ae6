#pragma once

#include <string>

#include "report/player.h"

namespace tricontact::animation {

/// A frame of a film as PNG: the field (of field_names) in its colours with their scale, arrows of
/// the traction, the instant, and where that is in the shift's history. `title`: of the case, may
/// be empty.
std::string film_picture(const report::Film& film, std::size_t frame, const std::string& field,
                         const std::string& title, const std::string& axis);

}  // namespace tricontact::animation
