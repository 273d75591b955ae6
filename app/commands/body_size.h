#pragma once

#include "runs/options.h"

namespace tricontact::app {

/// How large the body of a case's indenter has to be to press as a half-space does: body_size.json,
/// body_size.csv, the report, and a table on standard output. Finished runs of an earlier call are
/// taken over.
void compare_body_sizes(CommandOptions options);

}  // namespace tricontact::app
