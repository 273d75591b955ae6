#pragma once

#include "comparisons/document.h"
#include "comparisons/experiment_evaluation.h"

namespace tricontact::comparisons {

// Tables of an experiment's report.

DocumentTable values_table(const ExperimentEvaluation& e);        ///< u_stat, u_sd, Du
DocumentTable normalised_table(const ExperimentEvaluation& e);    ///< over Hertz' scales
DocumentTable deviations_table(const ExperimentEvaluation& e);    ///< of the models
DocumentTable criteria_table(const ExperimentEvaluation& e);      ///< walk and curvature, per run
DocumentTable stages_table(const ExperimentEvaluation& e);        ///< verdict per amplitude and run
DocumentTable limits_table(const ExperimentEvaluation& e);        ///< W_lim and U_lim per run
DocumentTable model_stages_table(const ExperimentEvaluation& e);  ///< models' verdicts
DocumentTable wobble_table(const ExperimentEvaluation& e);        ///< with the models' own
DocumentTable noise_table(const ExperimentEvaluation& e);         ///< noise, drift, wobble per run

}  // namespace tricontact::comparisons
