#pragma once

#include "io/keys/key_list.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Throws contact::InputError at a section or key that the list lacks ("did you mean"), at keys
/// that exclude each other, and at a key without the one it needs.
void check_known(const Document& document, const KeyList& keys);

/// Value of the key in the document, else its default; where the key has a place and neither, it
/// may be left out, or throws contact::InputError.
void read_or_default(const Key& key, const Field& field, const Document& document,
                     const KeyList& keys);

}  // namespace tricontact::io
