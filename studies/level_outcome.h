#pragma once

#include <optional>
#include <string>

#include "contact/case.h"
#include "contact/history.h"
#include "io/results/result_store.h"

namespace tricontact::studies {

/// What a refinement keeps of a level beside its results.
struct LevelState {
    std::optional<contact::Snapshot> last;   ///< positions, pressure, traction, displacement
    std::optional<double> normal_stiffness;  ///< [N/m]
};

/// Results of a level as text, fields to seven digits; with quantities of results_of.
std::string level_results_text(const contact::Case& c, const contact::History& history,
                               std::optional<double> normal_stiffness);

/// What PointKind::compute gives of a level: these results, and times.
std::string level_outcome_text(const contact::Case& c, const contact::History& history,
                               std::optional<double> normal_stiffness);

/// From such results; empty members where the text has none, as that of outcome_text.
LevelState level_state_of(const io::PointOutcome& outcome);

}  // namespace tricontact::studies
