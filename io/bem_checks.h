#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// bem.influence: the file is there, and one model is to use it. output.volume: the inside is
/// known. bem.period: the model is one whose mean displacement is defined, the period holds a whole
/// number of cells and more than the rolling path, and layers that cannot be compressed have room
/// to give way. Throws contact::InputError.
void check_bem_options(const contact::Case& c, const Document& document);

}  // namespace tricontact::io
