#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// What cylinder and roller cannot be combined with; nothing for other bodies. Throws
/// contact::InputError.
void check_line_contact(const contact::Case& c, const Document& document);

}  // namespace tricontact::io
