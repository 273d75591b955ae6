#pragma once

#include <string>

#include "contact/case.h"

namespace tricontact::atlas {

/// Why no atlas is about the case by this model, in words; empty if one is.
std::string what_is_not_mapped(const contact::Case& c, const std::string& model);

}  // namespace tricontact::atlas
