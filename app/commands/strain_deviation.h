#pragma once

#include "runs/options.h"

namespace tricontact::app {

/// How far the linear law of a case's layer is from one at finite strains: finite_strain.json,
/// finite_strain.csv, the report, and a table on standard output. `elements`: in the contact
/// radius. Finished runs of an earlier call are taken over.
void compare_with_finite_strains(CommandOptions options, double elements);

}  // namespace tricontact::app
