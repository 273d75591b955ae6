#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contact/case.h"
#include "io/keys/toml_document.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Reads a TOML case of the micro-walking machine; kappas, stiffnesses and times that follow from
/// others are filled in. `overrides` as in read_case.
/// Throws contact::InputError in one line: `file:line:column: key = value: rule; remedy`.
WalkCase read_walk_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// Same for a text; `name` stands for the file in messages.
WalkCase parse_walk_case(std::string_view text, const std::string& name,
                         const std::vector<std::string>& overrides = {});

/// The case of a document with the entries of another one in place of its own, as overrides are.
WalkCase resolve_walk_case(io::Document document, const std::vector<io::Entry>& overrides);

/// The resolved case as TOML, as io::write_case does it. `parse_walk_case` of the text yields the
/// same case.
std::string write_walk_case(const WalkCase& c);

/// What a case file may be about: a contact, or the micro-walking machine.
using AnyCase = std::variant<contact::Case, WalkCase>;

/// Reads a case of the kind that the file is; see read_case and read_walk_case. Throws
/// contact::InputError.
AnyCase read_any_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// Whether the file is about the machine. Throws contact::InputError if it cannot be read.
bool is_walk_case_file(const std::string& path);

}  // namespace tricontact::walking
