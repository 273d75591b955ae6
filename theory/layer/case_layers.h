#pragma once

#include "contact/case.h"
#include "theory/layer/layer_stack.h"

namespace tricontact::theory {

/// The layers of a case and what they rest on. `model`: asks for them, named in the message. Throws
/// contact::InputError if the case has no substrate.thickness, or no ground for a half-space.
LayerStack layers_of(const std::string& model, const contact::Case& c);

}  // namespace tricontact::theory
