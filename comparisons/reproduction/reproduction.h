#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparisons/reproduction/kept_numbers.h"

namespace tricontact::comparisons {

/// A quantity of a file whose values differ from the kept ones: where they differ most.
struct ChangedQuantity {
    std::string file, quantity, place;
    double kept = 0, now = 0;
    double difference = 0;  ///< relative: over the kept value, of lists and columns the largest one
    std::optional<double> stated_error = {};  ///< half width beside the kept value, in its unit
    std::size_t n = 0;                        ///< values that differ
    bool agrees = true;                       ///< all of them, as the comparison takes it
};

/// Kept numbers beside those of another run.
struct Reproduction {
    double tolerance = 0;
    std::size_t n_files = 0, n_numbers = 0;
    std::vector<ChangedQuantity> changed;  ///< by files, in their order
    std::vector<std::string> otherwise;  ///< words that differ, values and files missing on a side

    bool same_bytes() const { return changed.empty() && otherwise.empty(); }
    bool reproduces() const;
};

/// Compares file by file, value by value. A number agrees if it is within the relative tolerance,
/// or within the error that stands beside the kept one, or if the difference is the rounding of
/// sums: below 1e-10 of the largest number of its unit in the file. Throws std::runtime_error
/// where a kept file cannot be read.
Reproduction compare_with_kept(const NumberFiles& kept, const NumberFiles& now, double tolerance);

/// A table for people, the largest differences first, and what it comes to in the last line.
std::string reproduction_text(const Reproduction& reproduction);
nlohmann::ordered_json reproduction_json(const Reproduction& reproduction);

}  // namespace tricontact::comparisons
