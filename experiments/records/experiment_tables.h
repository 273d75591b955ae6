#pragma once

#include "experiments/records/experiment_evaluation.h"
#include "report/document.h"

namespace tricontact::experiments {

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
