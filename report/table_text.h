#pragma once

#include <cstddef>
#include <string>

#include "report/document.h"

namespace tricontact::report {

/// A table for the terminal, its numbers as on the page: a line of headings, one per row, columns
/// two spaces apart, words at the left and numbers at the right. `most_columns`: of the first ones.
std::string table_text(const DocumentTable& table, std::size_t most_columns = -1);

}  // namespace tricontact::report
