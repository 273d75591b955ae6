#pragma once

#include <optional>

#include "comparisons/half_space/layer.h"
#include "comparisons/shakedown/limit.h"
#include "theory/line_contact.h"

namespace tricontact::comparisons {

/// The exact frictionless plane contact of a cylinder with its layer; empty where there is no layer
/// or why_no_exact_theory() has a reason. Throws contact::InputError out of the theory's range,
/// contact::NotConverged.
std::optional<theory::LineContact> exact_line_contact(const contact::Case& c);

/// Its numbers over the cylinder's length; the shift of full sliding is left out.
PressedValues line_pressed_values(const contact::Case& c, const theory::LineContact& line);

/// Its limit of shakedown without coupling, in the units of the case's own ratios; empty where
/// there is none.
std::optional<double> line_layer_limit(const contact::Case& c, LimitVariable variable);

/// dF_N/dd [N/m] of a cylinder on the half-space at the half width a [m]: pi E* L/(2 ln(2 L/a)).
double line_stiffness(const contact::Case& c, double half_width);

}  // namespace tricontact::comparisons
