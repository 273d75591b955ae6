#pragma once

#include <span>
#include <string_view>

namespace tricontact::benchmarks {

/// A file of benchmarks/problems/data, embedded when the program is built.
struct ProblemFile {
    std::string_view name;  ///< without ending
    std::string_view text;
};

/// In the order of the catalogue.
std::span<const ProblemFile> problem_files();

}  // namespace tricontact::benchmarks
