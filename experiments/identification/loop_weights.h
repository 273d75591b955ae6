#pragma once

#include "contact/model_makers.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// Weighs the rows of friction loops by a first fit: an error of the shift counts by the slope
/// dF/dU of the fitted loop. Stated ones become errors of the force; of unstated ones the residuals
/// tell those of force and shift, whose ratio is what weighs the rows. Without loops nothing.
void weigh_loop_rows(IdentificationInput& input, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
