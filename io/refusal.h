#pragma once

#include <string>

#include "io/toml_document.h"

namespace tricontact::io {

/// Four significant digits.
std::string rounded(double value);

/// Throws contact::InputError `place: key = value: rule; remedy`; a key that the document lacks is
/// named with its section's place and "(default)".
[[noreturn]] void refuse(const Document& document, const std::string& path, const std::string& rule,
                         const std::string& remedy);

/// The key of an alternative pair that the case uses: the second if the document has it.
std::string used(const Document& document, const std::string& first, const std::string& second);

}  // namespace tricontact::io
