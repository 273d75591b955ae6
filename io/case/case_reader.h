#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "contact/case.h"
#include "io/keys/key.h"
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

/// The resolved case as TOML: every default written out, quantities in SI units with the shortest
/// digits that read back the same. `parse_case` of the text yields a bit-identical case.
std::string write_case(const contact::Case& c);

/// Puts `section.key=value` texts over the entries of a document. Alternatives of an overridden
/// key, and what hangs on them, vanish unless they are overrides themselves.
/// Throws contact::InputError at a malformed override and at a key set twice.
void apply_overrides(Document& document, const std::vector<std::string>& overrides,
                     const KeyList& keys);

/// The same for entries that another document gives; each path must be there once.
void apply_overrides(Document& document, const std::vector<Entry>& overrides, const KeyList& keys);

}  // namespace tricontact::io
