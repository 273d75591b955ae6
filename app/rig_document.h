#pragma once

#include <string>

#include "comparisons/document.h"
#include "rig/printed.h"

namespace tricontact::app {

/// What report.html says of a rig. `command`: that makes it again.
comparisons::Document rig_document(const rig::RigReport& report, const std::string& command);

}  // namespace tricontact::app
