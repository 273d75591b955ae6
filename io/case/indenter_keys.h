#pragma once

#include <string_view>

#include "contact/case.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// The word that stands for a shape in case files.
std::string_view word_of(contact::Case::Shape shape);

/// Throws contact::InputError at a key of [indenter] that the case's shape, which has been read,
/// does not take.
void check_indenter_keys(const contact::Case& c, const Document& document);

/// Reads what `indenter.file` holds of a profile. Throws contact::InputError at the key.
void resolve_indenter_file(contact::Case& c, const Document& document);

}  // namespace tricontact::io
