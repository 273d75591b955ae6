#pragma once

#include <string>

#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

inline constexpr std::string_view loop_table_header =
    "cycle, shift [um], tangential_force [N], normal_force [N]";

/// Reads friction loops: columns cycle, shift and tangential_force, and if they are there
/// normal_force, amplitude, and the standard errors tangential_force_error and shift_error, of
/// which the latter counts by the slope of the fitted loop, see weigh_rows(). `text`: of the
/// file called `name`. Throws contact::InputError.
void read_loop_table(IdentificationInput::Table& measured, const std::string& text,
                     const std::string& name);

}  // namespace tricontact::experiments
