#pragma once

#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// Reads `input.data_file`: the columns of the measurement and, if it is there, that of the
/// observed values' standard errors, `<observed>_error`. Throws contact::InputError.
void read_measured_table(IdentificationInput& input);

}  // namespace tricontact::experiments
