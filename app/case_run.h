#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/models.h"
#include "app/options.h"
#include "comparisons/run/loading_study.h"
#include "comparisons/run/report.h"
#include "contact/case.h"
#include "contact/history.h"
#include "contact/run.h"

namespace tricontact::app {

struct RunOptions : CommandOptions {
    bool studies = true;  ///< what needs further runs: other ways of loading, the elastic substrate
};

/// What the models of a case came to, and what further runs beside them found.
struct CaseRun {
    contact::Case c;
    std::string resolved;                     ///< the case as text
    std::vector<contact::History> histories;  ///< in the order of the case's models
    comparisons::ReportExtras extras;
};

/// Runs one model by its name; adds to the study, if there is one, what loading once more finds.
using ModelRun =
    std::function<contact::History(const std::string& name, comparisons::LoadingStudy* study)>;

/// Runs the case's models one after another, and what `options` want beside them. Throws
/// InputError, NotConverged.
CaseRun run_models(const contact::Case& c, const RunOptions& options, const Say& say,
                   const ModelRun& run_one);

/// The text of summary.json.
std::string summary_of(const CaseRun& run);

/// The history of one model, sound by its audit, without any files. Throws InputError,
/// NotConverged, and what the observer throws.
contact::History history_of(const std::string& name, const contact::Case& c, int n_threads,
                            const Say& say, const contact::Observer& observer = {},
                            comparisons::LoadingStudy* study = nullptr);

/// What run_model writes into the folder of the model, beside the files that the collections name.
inline const std::vector<std::string> model_results{"history.csv", "surface.pvd", "volume.pvd"};

/// The same with progress, with history and ParaView files in a folder of its own. A finite element
/// run that was killed goes on from its last finished step. `resolved` is the text of the case.
contact::History run_model(const std::string& name, const contact::Case& c,
                           const std::string& resolved, const RunOptions& options,
                           comparisons::LoadingStudy* study = nullptr);

/// Throws NotConverged if a check of the audit of the model called `name` failed.
void require_sound(const contact::Audit& audit, const std::string& name);

}  // namespace tricontact::app
