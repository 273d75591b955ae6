#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tricontact::report {

/// A number that follows from a case, without a run.
struct DerivedValue {
    std::string symbol;   ///< "U_max"
    double value = 0;     ///< in that unit
    std::string unit;     ///< of SI, "1": none
    std::string meaning;  ///< "shift at the onset of sliding"
};

/// A line for each, as comments of a TOML file: four digits, in the unit that fits.
std::string derived_lines(const std::vector<DerivedValue>& values);
/// An object with each symbol's value, unit and meaning.
nlohmann::ordered_json derived_json(const std::vector<DerivedValue>& values);

}  // namespace tricontact::report
