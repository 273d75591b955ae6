#pragma once

#include <span>
#include <string_view>

namespace tricontact::atlas {

/// A file of atlas/data, embedded when the program is built.
struct DataFile {
    std::string_view name;  ///< without ending
    std::string_view text;
};

/// In alphabetical order.
std::span<const DataFile> data_files();

}  // namespace tricontact::atlas
