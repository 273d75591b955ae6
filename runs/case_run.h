#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparisons/run/contact_film.h"
#include "comparisons/run/report.h"
#include "contact/run.h"
#include "runs/options.h"

namespace tricontact::runs {

/// What the models of a case came to, and what further runs beside them found.
struct CaseRun {
    Case c;
    std::string resolved;                     ///< the case as text
    std::vector<contact::History> histories;  ///< in the order of the case's models
    comparisons::ReportExtras extras;
};

/// Runs one model by its name; adds to the study, if there is one, what loading once more finds.
using ModelRun =
    std::function<contact::History(const std::string& name, comparisons::LoadingStudy* study)>;

/// Before anything is computed. Throws InputError if the program was built without one of the
/// case's models.
void require_models(const Case& c, const RunOptions& options);
/// Runs the case's models one after another, and what `options` want beside them. Throws
/// InputError, NotConverged.
CaseRun run_models(const Case& c, const RunOptions& options, const Say& say,
                   const ModelRun& run_one);

/// The text of summary.json.
std::string summary_of(const CaseRun& run);

/// Writes report.html and the plots into the folder of the output.
void write_run_report(const CaseRun& run, const CommandOptions& options);

/// The history of one model, sound by its audit, without any files; adds to the study, if there is
/// one, what loading once more finds. Throws InputError, NotConverged, and what the observer
/// throws.
contact::History studied_history(const std::string& name, const Case& c, const RunOptions& options,
                                 const Say& say, const contact::Observer& observer,
                                 comparisons::LoadingStudy* study);

/// What run_model writes into the folder of the model, beside the files that the collections name.
inline const std::vector<std::string> model_results{"history.csv", "surface.ex2", "indenter.ex2",
                                                    "volume.ex2"};

/// The same with progress, with history and ParaView files in a folder of its own. A finite element
/// run that was killed goes on from its last finished step. `resolved` is the text of the case.
contact::History run_model(const std::string& name, const Case& c, const std::string& resolved,
                           const RunOptions& options, comparisons::LoadingStudy* study = nullptr,
                           comparisons::ContactFilm* film = nullptr);

}  // namespace tricontact::runs
