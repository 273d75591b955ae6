#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Reads what `indenter.file` holds. Throws contact::InputError at the key.
void resolve_indenter_file(contact::Case& c, const Document& document);

}  // namespace tricontact::io
