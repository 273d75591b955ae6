#pragma once

#include <string>

#include "app/case_run.h"

namespace tricontact::app {

/// What a run came to, as lines for people: of each model state, shift in micrometres or the like
/// and in its U_max, time. Without rolling and tangential force: the pressed contact.
std::string run_text(const CaseRun& run);

}  // namespace tricontact::app
