#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tricontact::io {

/// The known path ("section.key") that an unknown one was meant to be: the same name in another
/// section, the name behind a symbol ("E" is young), a name nearly or partly the same. Empty if
/// there is none.
std::string likely_path(std::string_view path, std::span<const std::string_view> known);

}  // namespace tricontact::io
