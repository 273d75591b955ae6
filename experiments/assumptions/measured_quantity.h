#pragma once

#include <string_view>

#include "io/keys/units.h"
#include "statistics/estimate.h"

namespace tricontact::experiments {

using statistics::Estimate;

/// A number as somebody wrote it down, SI units.
struct MeasuredQuantity {
    Estimate value;
    double half_digit = 0;        ///< half a unit of the last written digit
    double half_error_digit = 0;  ///< the same of the error; 0 without one
};

/// "62.17 ± 5.38 um", "62.17 +- 5.38 um" or "62.17 um"; the unit stands once, behind the error.
/// Pure numbers (Dimension::none) have no unit. Throws QuantityError.
MeasuredQuantity parse_measured_quantity(std::string_view text, io::Dimension dimension);

}  // namespace tricontact::experiments
