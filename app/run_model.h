#pragma once

#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "comparisons/run/loading_study.h"
#include "contact/case.h"
#include "contact/history.h"

namespace tricontact::app {

/// Name of the resolved case beside its results.
inline constexpr const char* resolved_case_name = "case.toml";

/// What run_model writes into the folder of the model, beside the files that the collections name.
inline const std::vector<std::string> model_results{"history.csv", "surface.pvd", "volume.pvd"};

/// One model of a case: its steps with progress, its history and its ParaView files in a folder of
/// its own. A finite element run that was killed goes on from its last finished step. `resolved` is
/// the text of the case. Adds to `study`, if asked for, what loading once more finds (see
/// loading_study.h). Throws InputError, NotConverged.
contact::History run_model(const std::string& name, const contact::Case& c,
                           const std::string& resolved, const RunOptions& options,
                           comparisons::LoadingStudy* study = nullptr);

}  // namespace tricontact::app
