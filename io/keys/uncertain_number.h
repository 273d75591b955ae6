#pragma once

#include <string_view>

#include "io/keys/units.h"
#include "statistics/distribution.h"
#include "statistics/estimate.h"

namespace tricontact::io {

/// A number as somebody wrote it down, SI units.
struct UncertainNumber {
    statistics::Estimate value;  ///< with its standard error; 0: none is stated
    statistics::Distribution distribution = statistics::Distribution::normal;
    double half_digit = 0;        ///< half a unit of the last written digit
    double half_error_digit = 0;  ///< the same of the error; 0 without one, or if it is in percent
};

/// Whether the text states an uncertainty: it has a ±.
bool states_uncertainty(std::string_view text);

/// "62.17 ± 5.38 um", "62.17 +- 5.38 um", "12 MPa ± 5 %" or "62.17 um", behind it "(uniform)" or
/// "(triangular)" where the number behind ± is half the width of such a distribution, not a
/// standard error. A unit stands once, behind the error, except where that has one of its own or is
/// in percent. Pure numbers (Dimension::none) have no unit. Throws QuantityError.
UncertainNumber parse_uncertain_number(std::string_view text, Dimension dimension);

}  // namespace tricontact::io
