#include "comparisons/quantities/change_table.h"

#include "report/format.h"

namespace tricontact::comparisons {

using report::DocumentTable;

std::vector<DocumentTable::Column> quantity_columns() {
    return {{"quantity"}, {"unit"}};
}

DocumentTable::Column change_column(const std::string& of, const std::string& to) {
    return {.heading = of + " vs " + to + " [%]", .change = true};
}

report::Cell change_cell(std::optional<double> value, std::optional<double> base) {
    const bool has_both = value && base && *base != 0;
    return report::number_cell(has_both ? std::optional(100 * (*value / *base - 1)) : std::nullopt);
}

}  // namespace tricontact::comparisons
