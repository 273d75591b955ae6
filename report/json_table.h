#pragma once

#include <string>
#include <vector>

#include "report/document.h"
#include "report/json_number.h"
#include "statistics/estimate.h"

// The object in JSON of a result says each of its values once; CSV and tables, which pages and
// terminal (table_text.h) show, take them from there by their keys:
//
//     const Json runs = list_of(study.runs, run_json);  // {"model": "mdr", "shift_m": 1e-5, ...}
//     text = csv_of(runs, {"model", "shift_m"});
//     table = table_of({.id = "runs", .title = "All runs"}, runs,
//                      {{"model", "model"}, {"shift_m", "U [µm]:3", 1e-6}});

/// A value and how well it is known.
template <>
struct nlohmann::adl_serializer<tricontact::statistics::Estimate> {
    template <class Json>
    static void to_json(Json& json, const tricontact::statistics::Estimate& e) {
        json = {{"value", e.value},
                {"standard_error", e.standard_error},
                {"low", e.low},
                {"high", e.high}};
    }
};

namespace tricontact::report {

/// A column of a table of results.
struct ValueColumn {
    /// Of the value in a result's object; where it stands deeper a JSON pointer:
    /// "/comparison/difference_m".
    std::string key;
    std::string heading;   ///< with unit and digits as those of columns()
    double unit = 1;       ///< of the heading, in SI
    std::string bar = {};  ///< key of the half width of its interval; empty: none, or its own
};

/// A value over its unit as a cell: words and counts as they are, "yes" or "no", an undefined
/// number; with its bar where that is a number. An object has its "value" with half the distance of
/// "low" and "high" as bar, else its "standard_error".
Cell cell_of(const nlohmann::ordered_json& value, double unit = 1,
             const nlohmann::ordered_json& bar = nullptr);

/// `head` and columns behind those that it has, a row for each of the results, an array; "model"
/// is shown by its title. Throws nlohmann's out_of_range for a key that they have not.
DocumentTable table_of(DocumentTable head, const nlohmann::ordered_json& results,
                       const std::vector<ValueColumn>& columns);

/// The keys, then a line for each of the results. Throws as table_of().
std::string csv_of(const nlohmann::ordered_json& results, const std::vector<std::string>& keys);

}  // namespace tricontact::report
