#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Rules that concern several keys at once: friction limit, coupling of the materials, scale of
/// the contact against the indenter, resolution and cost. Errors point into the document.
/// Throws contact::InputError.
void check_case(const contact::Case& c, const Document& document);

}  // namespace tricontact::io
