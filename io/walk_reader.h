#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dynamics/walk_case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Whether the file is about the micro-walking machine: it has a section [machine].
bool is_walk_case(const Document& document);

/// Reads a TOML case of the micro-walking machine; kappas, stiffnesses and times that follow from
/// others are filled in. `overrides` as in read_case.
/// Throws contact::InputError in one line: `file:line:column: key = value: rule; remedy`.
dynamics::WalkCase read_walk_case(const std::string& path,
                                  const std::vector<std::string>& overrides = {});

/// Same for a text; `name` stands for the file in messages.
dynamics::WalkCase parse_walk_case(std::string_view text, const std::string& name,
                                   const std::vector<std::string>& overrides = {});

/// The case of a document with the entries of another one in place of its own, as overrides are.
dynamics::WalkCase resolve_walk_case(Document document, const std::vector<Entry>& overrides);

}  // namespace tricontact::io
