#pragma once

#include <string>

#include "statistics/uncertain.h"

namespace tricontact::experiments {

/// A number that a publication states, SI units.
struct PrintedValue {
    std::string name;             ///< of the quantity: "contact_radius"
    std::string text;             ///< as printed: "4.56 mm"
    statistics::Uncertain value;  ///< with the printed error, 0 if there is none
    double half_digit = 0;        ///< half a unit of the last digit of the value ...
    double half_error_digit = 0;  ///< ... and of its error
    std::string source;           ///< "table 5.1.1"
};

}  // namespace tricontact::experiments
