#pragma once

#include <string>

#include "benchmarks/reference/reference.h"
#include "contact/case.h"

namespace tricontact::app {

/// What parts of `tricontact benchmark` are about.
struct BenchmarkCase {
    std::string name;   ///< of the catalogue, or of the file without its ending
    std::string title;  ///< of the problem, or of the case
    contact::Case c;
    std::string text;  ///< of the file; empty: of the catalogue
};

/// A problem of the catalogue by its name, else a case file, of which relative names are also
/// looked up in `folder`. Throws contact::InputError where it is neither.
BenchmarkCase benchmark_case(const std::string& name_or_file, const std::string& folder = {});

/// The reference of a case, computed or kept from an earlier call. Throws what
/// benchmarks::reference throws.
benchmarks::Reference reference_of_case(const contact::Case& c, int n_threads,
                                        const contact::Say& say);

}  // namespace tricontact::app
