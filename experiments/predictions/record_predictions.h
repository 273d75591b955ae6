#pragma once

#include <string>
#include <vector>

#include "contact/model_makers.h"
#include "experiments/records/experiment.h"
#include "experiments/records/experiment_evaluation.h"

namespace tricontact::experiments {

/// Who computes predictions of the models, and how the case is read.
struct PredictionRuns {
    contact::ModelRunner runner;
    std::vector<std::string> overrides;  ///< key=value
    contact::Say say;                    ///< hears of each run
};

/// Adds what the models of the input's case say of the rig as it was rolled: the shift over the
/// periods with its uncertainty, of limit runs the verdict at each amplitude. They roll at the
/// record's amplitude and, on a relaxing substrate, its rest and speed; where the records hold
/// forces they follow these and the drive row by row. Throws contact::InputError,
/// contact::NotConverged.
void add_predictions(ExperimentEvaluation& evaluation, const ExperimentInput& input,
                     const PredictionRuns& runs);

}  // namespace tricontact::experiments
