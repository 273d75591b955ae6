#pragma once

#include <filesystem>
#include <optional>

namespace tricontact::files {

/// Folder of what this code is a part of: the program, or the module of Python.
std::filesystem::path own_folder();

/// A module or program that belongs to the program and is used when needed: beside us in a build;
/// installed, below the folder of libraries. Empty if it is not there.
std::optional<std::filesystem::path> find_part(const char* file);

}  // namespace tricontact::files
