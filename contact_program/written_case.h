#pragma once

#include <optional>
#include <string>

namespace tricontact::contact_program {

/// The input file of CONTACT with the case (TOML) that it was written of, which CONTACT skips:
/// numbers alone do not tell a layer, or a body given by its heights.
std::string with_written_case(const std::string& input, const std::string& case_text);

/// The case that stands in such a file; empty where there is none, or where the file has been
/// changed since.
std::optional<std::string> written_case(const std::string& input);

}  // namespace tricontact::contact_program
