#pragma once

#include "comparisons/differences/results_folder.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// Keys of the case that differ.
report::DocumentTable change_table(const FolderComparison& comparison);
/// Numbers side by side; `lists`: those per period instead of the others.
report::DocumentTable number_table(const RunPair& pair, bool lists);
/// Differences of surfaces in the last common instant, a row per pair.
report::DocumentTable folder_field_table(const FolderComparison& comparison);

}  // namespace tricontact::comparisons
