#pragma once

#include "contact/model_makers.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// Weighs the rows of friction loops, and of force curves of surfaces that attract each other, by a
/// first fit: an error of the shift or depth counts by the slope of the fitted curve. Stated ones
/// become errors of the force; of unstated ones the residuals tell those of force and shift, whose
/// ratio is what weighs the rows. Without such tables nothing.
void weigh_rows(IdentificationInput& input, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
