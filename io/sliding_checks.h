#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// F_T points along x except where the body rolls on. Throws contact::InputError.
void check_direction_of_force(const contact::Case& c, const Document& document);

/// F_T stays below mu F_N all along the path, by what the models can tell. With a prescribed
/// indentation they find F_N, and check again. Throws contact::InputError.
void check_friction_limit(const contact::Case& c, const contact::HalfSpaceScales& scales,
                          const Document& document);

}  // namespace tricontact::io
