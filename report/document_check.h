#pragma once

#include "report/document.h"

namespace tricontact::report {

/// Throws std::invalid_argument that names the figure or table whose id is no word or not its own,
/// or whose columns differ in length.
void check_document(const Document& document);

}  // namespace tricontact::report
