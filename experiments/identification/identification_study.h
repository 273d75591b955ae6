#pragma once

#include "contact/model_makers.h"
#include "experiments/identification/identification_report.h"

namespace tricontact::experiments {

/// What the models of the input find in its tables, without command and version, which are the
/// program's. `say` hears the name of each model. Throws contact::InputError (see
/// check_lengths_scale(), which comes before), contact::NotConverged, also where interpolated
/// values are off the model's own.
IdentificationStudy identification_study(const IdentificationInput& input, bool draws_posterior,
                                         const contact::ModelRunner& runner,
                                         const contact::Say& say);

}  // namespace tricontact::experiments
