#pragma once

#include <string>
#include <vector>

#include "contact/bodies/profile_curve.h"
#include "contact/substrates/dma_fit.h"
#include "contact/substrates/relaxation_test.h"

namespace tricontact::io {

/// The profile of a body of revolution from a CSV table: columns r and h with their units, from
/// (0, 0) on, radii increasing and heights not falling, and perhaps a column `kink` of 0 and 1, 1
/// where the slope jumps. Throws contact::InputError.
std::vector<contact::ProfileCurve::Point> read_profile_table(const std::string& path);

/// Reads a table of dynamic mechanical analysis, see CsvTable: `frequency [Hz], G' [MPa], G''
/// [MPa]`, in this order. The frequency may be in rad/s and is then angular. A fourth column
/// `temperature` may show that it is one. Throws contact::InputError `file:line: rule; remedy`.
contact::DmaTable read_dma_table(const std::string& path);

/// Reads a table of a relaxation test: `time [s], E [MPa]`, or G. Throws contact::InputError.
contact::RelaxationTest read_relaxation_test(const std::string& path);

}  // namespace tricontact::io
