#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/models/make_model.h"
#include "comparisons/run/contact_film.h"
#include "comparisons/run/report.h"
#include "contact/run.h"

namespace tricontact::app {

struct RunOptions : CommandOptions {
    bool studies = true;  ///< what needs further runs: other ways of loading, the elastic substrate
};

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

/// Runs the case's models one after another, and what `options` want beside them. Throws
/// InputError, NotConverged.
CaseRun run_models(const Case& c, const RunOptions& options, const Say& say,
                   const ModelRun& run_one);

/// The text of summary.json.
std::string summary_of(const CaseRun& run);

/// Writes report.html and the plots into the folder of the output.
void write_run_report(const CaseRun& run, const CommandOptions& options);

/// The history of one model, sound by its audit, without any files. Throws InputError,
/// NotConverged, and what the observer throws.
contact::History history_of(const std::string& name, const Case& c, int n_threads, const Say& say,
                            const contact::Observer& observer = {},
                            comparisons::LoadingStudy* study = nullptr);

/// The same on cells, elements and springs of twice the size.
contact::History history_of_coarser(const std::string& name, const Case& c, int n_threads);

/// What run_model writes into the folder of the model, beside the files that the collections name.
inline const std::vector<std::string> model_results{"history.csv", "surface.pvd", "indenter.pvd",
                                                    "volume.pvd"};

/// The same with progress, with history and ParaView files in a folder of its own. A finite element
/// run that was killed goes on from its last finished step. `resolved` is the text of the case.
contact::History run_model(const std::string& name, const Case& c, const std::string& resolved,
                           const RunOptions& options, comparisons::LoadingStudy* study = nullptr,
                           comparisons::ContactFilm* film = nullptr);

// What runs beside the models of a case find.

/// Loads a model whose normal and tangential contact are coupled a few times more, on the
/// elasticity that `model` already has, and adds to `study`: what coupling and the way of pressing,
/// one after another, change in the static shift and in that after rolling; and the stiffness
/// without friction, from presses at 0.6, 0.8 and 1 times the normal load. `history` is that of the
/// case's run with `model`; `say` hears of each. Models without such choices add nothing.
///
/// Rolling is by turning points until nothing moves, also of what the variants are compared with;
/// where the run ratchets, in its own steps if these are few.
void study_loading(const Case& c, const contact::Model& model, const contact::History& history,
                   const Say& say, comparisons::LoadingStudy& study);

/// Adds to `study` what the drive means for a relaxing case and, if `options` want studies, the
/// comparison of `history`, that of the case's run with a model, with an elastic reference run of
/// the substrate. The first model that comes here then also looks for the slowest drive speed at
/// which that errs by 1 % (find_speed_limit). Finite elements are too costly for either. Elastic
/// cases add nothing.
void study_relaxation(const Case& c, const contact::History& history, const RunOptions& options,
                      const Say& say, comparisons::RelaxationStudy& study);

/// Adds to `studies` what small strains would change in the run of a model at finite ones: run once
/// more with a linear material, if `options` want studies. Other models add nothing.
void study_small_strains(const Case& c, const contact::History& history, const RunOptions& options,
                         const Say& say, std::vector<comparisons::SmallStrains>& studies);

/// What mesh and steps leave in the numbers of a model, by runs on coarser ones with no more files;
/// `history` is that of the case's run. Empty unless `options` want studies.
std::optional<comparisons::NumericalError> numerical_error(const Case& c,
                                                           const contact::History& history,
                                                           const RunOptions& options,
                                                           const Say& say);

/// Throws NotConverged if a check of the audit of the model called `name` failed.
void require_sound(const contact::Audit& audit, const std::string& name);

}  // namespace tricontact::app
