#pragma once

#include "contact/case.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Turns whichever of the three ways a case took (`relaxation_input`) into the branches of
/// `relaxation`, and into the moduli and times that say the same. Without relaxation it does
/// nothing. Throws contact::InputError; contact::NotConverged if no series fits a DMA table.
void resolve_relaxation(contact::Case& c, const Document& document);

/// Makes moduli and times say what `relaxation` is, wherever it comes from.
void state_relaxation(contact::Case& c);

/// Rules for a relaxing substrate: steps between turning points, and a bulk modulus that the
/// models can take. Throws contact::InputError.
void check_relaxation(const contact::Case& c, const Document& document);

}  // namespace tricontact::io
