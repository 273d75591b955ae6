#pragma once

#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "contact/case.h"

namespace tricontact::comparisons {

/// A table of the report. Labels and units are HTML, cells are plain text.
struct Table {
    struct Row {
        std::string label;               ///< HTML: symbols with subscripts
        std::string unit;                ///< HTML
        std::vector<std::string> cells;  ///< one per column
    };
    struct Group {
        std::string title;  ///< empty: no heading
        std::vector<Row> rows;
    };
    std::string name;                  ///< for screen readers
    std::vector<std::string> columns;  ///< after label and unit
    std::vector<Group> groups;
};

/// Bodies, load, rolling path, and what follows from them by Hertz.
std::vector<Table> setting_tables(const contact::Case& c);

/// Models side by side, the closed forms, and differences to the last model (with one model: to
/// the closed forms).
Table results_table(const contact::Case& c, const std::vector<Results>& results);

/// u, its increment and the frictional work after each period.
Table period_table(const std::vector<Results>& results);

/// Each model's checks: worst violation, what is allowed, verdict.
Table audit_table(const std::vector<Results>& results);

}  // namespace tricontact::comparisons
