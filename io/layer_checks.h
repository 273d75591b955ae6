#pragma once

#include <string>

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Makes the case's lower layers of the lists of [lower_layer]. Throws contact::InputError if the
/// lists differ in length.
void resolve_lower_layers(contact::Case& c, const Document& document);

/// The lists of [lower_layer] from the case's lower layers, for the writer.
void state_lower_layers(contact::Case& c);

/// [ground] and substrate.base = "half-space" go together. Throws contact::InputError.
void check_ground(const contact::Case& c, const Document& document);

/// The case has layers that this model can take. Throws contact::InputError.
void check_layer(const std::string& model, const contact::Case& c, const Document& document);

}  // namespace tricontact::io
