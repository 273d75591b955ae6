#pragma once

#include <span>
#include <string>
#include <string_view>

namespace tricontact::io {

/// The known path ("section.key") that an unknown one was meant to be: the same name in another
/// section, the name behind a symbol ("E" is young), a name nearly or partly the same. Empty if
/// there is none.
std::string likely_path(std::string_view path, std::span<const std::string_view> known);

/// The remedy "did you mean <near>?", another one if there is no near one.
std::string did_you_mean(std::string_view near, std::string_view otherwise);

}  // namespace tricontact::io
