#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tricontact::comparisons {

/// Files of numbers by their names, JSON and CSV.
using NumberFiles = std::map<std::string, std::string>;

/// One value of a file.
struct KeptNumber {
    std::string quantity;                     ///< "models/mdr/shift_ratio_per_period", "u [mm]"
    std::string place;                        ///< in the file: with the index, or the line
    std::string text;                         ///< as it stands there
    std::optional<double> value = {};         ///< empty: words, or nothing
    std::optional<double> stated_error = {};  ///< half width that stands beside it
    double scale = 0;                         ///< largest of a list or column that it is in
    double noise_scale = 0;                   ///< largest of the same unit in the file
};

/// All values of a file in its order, but for the version of the program and the times that it
/// took. Stated errors: CSV columns "± <heading>" behind a column; in JSON "error" or
/// "standard_error" beside "value", "allowed" beside "worst", KEY_error beside KEY, and a run's
/// `numerical_error`. Throws std::runtime_error if it is neither JSON nor CSV.
std::vector<KeptNumber> numbers_in(const std::string& name, const std::string& text);

}  // namespace tricontact::comparisons
