#pragma once

#include <string>

#include "contact/case.h"

namespace tricontact::io {

/// Throws InputError if the case rolls on, which `tricontact run` alone computes.
void refuse_rolling_on(const contact::Case& c, const std::string& case_file);
/// Throws InputError unless it does.
void require_rolling_on(const contact::Case& c, const std::string& case_file);

}  // namespace tricontact::io
