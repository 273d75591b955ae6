#pragma once

#include "contact/case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Refuses what does not go with [tractive_rolling]. Throws contact::InputError.
void check_tractive_rolling(const contact::Case& c, const Document& document);

/// Steps of a case that rolls on, at most: loading, then one per cell. The case has to be one.
double steps_of_tractive_rolling(const contact::Case& c, const contact::HalfSpaceScales& scales);

}  // namespace tricontact::io
