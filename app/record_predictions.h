#pragma once

#include "experiments/records/experiment.h"
#include "experiments/records/experiment_evaluation.h"
#include "runs/options.h"

namespace tricontact::app {

/// Adds what the models of the input's case say of the rig as it was rolled: the shift over the
/// periods with its uncertainty, of limit runs the verdict at each amplitude. They roll at the
/// record's amplitude and, on a relaxing substrate, its rest and speed; where the records hold
/// forces they follow these and the drive row by row. Throws contact::InputError,
/// contact::NotConverged.
void add_predictions(experiments::ExperimentEvaluation& evaluation,
                     const experiments::ExperimentInput& input, const CommandOptions& options);

}  // namespace tricontact::app
