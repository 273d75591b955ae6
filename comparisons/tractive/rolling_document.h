#pragma once

#include "comparisons/document.h"
#include "comparisons/tractive/rolling_report.h"

namespace tricontact::comparisons::tractive {

/// The report of `tricontact roll`.
Document rolling_document(const RollingReport& report);

}  // namespace tricontact::comparisons::tractive
