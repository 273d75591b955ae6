#include "report/json_number.h"

#include <fmt/format.h>

#include <string>

namespace tricontact::report {

double to_digits(double value, int digits) {
    return std::stod(fmt::format("{:.{}g}", value, digits));
}

}  // namespace tricontact::report
