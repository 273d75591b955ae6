#pragma once

#include <string>

#include "contact/load_path.h"
#include "contact/vector2.h"

namespace tricontact::mdr {

/// Throws contact::InputError if the step loads or shifts across the load (y): a line of springs
/// has one direction. `model`: named in the message.
void check_on_line(const std::string& model, const contact::LoadStep& step);

/// Signed path length [m] of a rolling offset on the line through the origin along the unit vector
/// `direction`. Throws contact::InputError for an offset off that line, by more than rounding on
/// the path length and `spacing` [m].
double line_coordinate(const std::string& model, const contact::Vector2& offset,
                       const contact::Vector2& direction, double spacing);

}  // namespace tricontact::mdr
