#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "io/keys/toml_document.h"

namespace tricontact::io {

/// A number, or a list of numbers, as people type it, where TOML is stricter (".24", "5.", "+.5",
/// "007") or calls a whole number none ("1e4"). Empty for what else TOML has ("1_000", "inf").
std::optional<Value> entered_number(std::string_view text);

/// Whether this line (from 1 on) of a text has a number that begins with its point.
bool has_bare_point(std::string_view text, std::size_t line);

}  // namespace tricontact::io
