#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::comparisons {

/// Null if there is none.
inline const report::DocumentSection* find_section(const report::Document& document,
                                                   const std::string& id) {
    const auto found = std::ranges::find(document.sections, id, &report::DocumentSection::id);
    return found == document.sections.end() ? nullptr : &*found;
}

inline std::vector<std::string> headings(const report::DocumentTable& table) {
    std::vector<std::string> result;
    for (const auto& column : table.columns) result.push_back(column.heading);
    return result;
}

}  // namespace tricontact::comparisons
