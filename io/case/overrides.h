#pragma once

#include <string>
#include <vector>

#include "io/keys/key_list.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Puts `section.key=value` texts over the entries of a document. Alternatives of an overridden
/// key, and what hangs on them, vanish unless they are overrides themselves.
/// Throws contact::InputError at a malformed override and at a key set twice.
void apply_overrides(Document& document, const std::vector<std::string>& overrides,
                     const KeyList& keys);

/// The same for entries that another document gives; each path must be there once.
void apply_overrides(Document& document, const std::vector<Entry>& overrides, const KeyList& keys);

}  // namespace tricontact::io
