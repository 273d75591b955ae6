#pragma once

#include <string>
#include <string_view>

#include "meshes/hex_mesh.h"

namespace tricontact::meshes {

/// Throws contact::InputError `name: what; remedy` in one line.
[[noreturn]] void fail(std::string_view name, std::string_view what, std::string_view remedy);

/// A name out of a file, in quotes, at most 40 bytes long, without control characters.
std::string in_quotes(std::string_view text);

/// "(0.001, 0, -0.0025) m".
std::string place(const Point& point);

/// All names of Boundary ("contact, free_top, ...") or of Region.
template <class What>
std::string all_names() {
    std::string names;
    for (int i = 0; i < n_names<What>; ++i)
        names.append(i == 0 ? "" : ", ").append(name_of(static_cast<What>(i)));
    return names;
}

}  // namespace tricontact::meshes
