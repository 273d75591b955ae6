#pragma once

#include <vector>

#include "io/case/study_reader.h"
#include "io/keys/key_list.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// The keys below [set] of a study, as entries of a case that has these keys. Throws
/// contact::InputError.
std::vector<Entry> read_settings(const Document& document, const KeyList& keys);

/// The keys below [vary], each with its list or range. Throws contact::InputError.
std::vector<Study::Axis> read_axes(const Document& document, const KeyList& keys);

}  // namespace tricontact::io
