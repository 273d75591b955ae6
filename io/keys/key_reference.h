#pragma once

#include <string>

#include "io/keys/key.h"

namespace tricontact::io {

/// The reference of all keys of a kind of input file, as their declarations say it: Markdown, a
/// heading of the third level and a table per section.
std::string key_reference(const KeyList& keys);

}  // namespace tricontact::io
