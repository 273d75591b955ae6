#pragma once

#include "io/keys/key.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Puts the value of an entry into the field of its key: type, unit, choice and range are checked.
/// An empty field is left alone after the checks. Throws contact::InputError.
void read_field(const Key& key, const Entry& entry, const Field& field);
/// The choice that the entry makes of those of its key. Throws contact::InputError.
const Choice& read_choice(const Key& key, const Entry& entry);

}  // namespace tricontact::io
