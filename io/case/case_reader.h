#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/keys/toml_document.h"

namespace tricontact::io {

/// Reads a TOML case file, all quantities converted to SI units.
/// `overrides` are texts `section.key=value`, the value in TOML or, failing that, a bare string;
/// setting one of several alternative keys removes the others of the file. `models`, if there are
/// any, take the place of the case's.
/// Throws contact::InputError in one line: `file:line:column: key = value: rule; remedy`.
contact::Case read_case(const std::string& path, const std::vector<std::string>& overrides = {},
                        const std::vector<std::string>& models = {});

/// Same for a text; `name` stands for the file in messages.
contact::Case parse_case(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides = {});

/// The case of a document with the entries of another one in place of its own, as overrides are.
contact::Case resolve_case(Document document, const std::vector<Entry>& overrides);

}  // namespace tricontact::io
