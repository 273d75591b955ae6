#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::comparisons {

/// The first two columns of a table with a quantity per row.
std::vector<report::DocumentTable::Column> quantity_columns();
/// A column of differences in percent.
report::DocumentTable::Column change_column(const std::string& of, const std::string& to);
/// A ratio as such a difference; undefined without either value or where `base` vanishes.
report::Cell change_cell(std::optional<double> value, std::optional<double> base);

}  // namespace tricontact::comparisons
