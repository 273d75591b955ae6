#pragma once

#include <string>
#include <vector>

#include "io/results/result_store.h"

namespace tricontact::app {

/// A point of a study in the table.
struct TableRow {
    std::vector<std::string> fields;  ///< what the study says of it
    std::string key;                  ///< of its results in the store
};

/// The results as CSV: a row per point, its fields under their headings, then results by name, and
/// error. The same points give the same bytes, however they came about.
std::string sweep_table(const std::vector<std::string>& headings,
                        const std::vector<std::string>& result_names,
                        const std::vector<TableRow>& rows, const io::ResultStore& store);

}  // namespace tricontact::app
