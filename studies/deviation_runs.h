#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/results.h"
#include "runs/options.h"
#include "studies/study_kind.h"

/// What the deviations from a half-space, of sizes and from finite strains have in common: runs of
/// cases of their own, kept in the folder of the output.
namespace tricontact::studies {

/// The run of a case by its first model, at a level. `file`: of the user's case, for messages.
/// Throws contact::InputError: whatever the user's case passes, that of a run is checked by itself.
StudyPoint deviation_point(const contact::Case& c, int level, const std::string& file);

/// Of the points, in their order; empty where a run did not converge. Finished runs of an earlier
/// call are taken over.
std::vector<std::optional<comparisons::Results>> deviation_results(
    const runs::CommandOptions& options, const StudyPoints& points);

/// "tricontact deviation case.toml --set ...", for the report.
std::string deviation_command(const runs::CommandOptions& options);

}  // namespace tricontact::studies
