#pragma once

#include <string>
#include <vector>

#include "report/document.h"

namespace tricontact::report {

/// A column by its heading, with the significant digits of its numbers behind a colon where these
/// are not four: "w:3".
inline DocumentTable::Column column(const std::string& text) {
    const auto colon = text.rfind(':');
    if (colon == std::string::npos) return {text};
    return {text.substr(0, colon), std::stoi(text.substr(colon + 1))};
}

/// The columns of a table, each as above.
template <class... Texts>
std::vector<DocumentTable::Column> columns(const Texts&... texts) {
    return {column(texts)...};
}

}  // namespace tricontact::report
