#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Reads the file of a height map. Throws contact::InputError.
void resolve_height_map(contact::Case& c, const Document& document);

/// Height maps, planes and roughness: models that can, a period that fits, cells that resolve, and
/// nothing that refers to a radius of contact where there is none. Throws contact::InputError.
void check_rough_bodies(const contact::Case& c, const Document& document);

}  // namespace tricontact::io
