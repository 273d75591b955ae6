#pragma once

#include <string>
#include <vector>

#include "contact/history.h"
#include "experiments/records/experiment_evaluation.h"
#include "report/document.h"

namespace tricontact::experiments {

/// What the experiment says, one statement each, the answer first.
std::vector<report::Verdict> experiment_verdicts(const ExperimentEvaluation& e);

/// The text of experiment.json: fixed keys in fixed order, SI units in the names, undefined and
/// non-finite numbers as null.
std::string experiment_json(const std::string& version, const ExperimentEvaluation& e);

/// The report: verdicts, records, values over the periods with the models, criteria, tables. Title,
/// command, version and files are left to the caller.
report::Document experiment_document(const ExperimentEvaluation& e);

/// "shakedown", or "cannot tell".
std::string word(contact::State state);

/// From metres to the units in which people read shifts and amplitudes.
inline constexpr double um = 1e6, nm = 1e9, mm = 1e3;

// Tables of an experiment's report.

report::DocumentTable values_table(const ExperimentEvaluation& e);      ///< u_stat, u_sd, Du
report::DocumentTable normalised_table(const ExperimentEvaluation& e);  ///< over Hertz' scales
report::DocumentTable deviations_table(const ExperimentEvaluation& e);  ///< of the models
report::DocumentTable criteria_table(
    const ExperimentEvaluation& e);  ///< walk and curvature, per run
report::DocumentTable stages_table(
    const ExperimentEvaluation& e);  ///< verdict per amplitude and run
report::DocumentTable limits_table(const ExperimentEvaluation& e);  ///< W_lim and U_lim per run
report::DocumentTable model_stages_table(const ExperimentEvaluation& e);  ///< models' verdicts
report::DocumentTable wobble_table(const ExperimentEvaluation& e);        ///< with the models' own
report::DocumentTable noise_table(const ExperimentEvaluation& e);  ///< noise, drift, wobble per run

}  // namespace tricontact::experiments
