#include "report/format_share.h"

#include <cmath>

#include "report/format.h"

namespace tricontact::report {

namespace {

constexpr double least_p = 1e-3;
constexpr double least_share = 1e-5;

}  // namespace

std::string p_value(double p) {
    return p < least_p ? "p < 0.001" : "p = " + significant(p, 2);
}

std::string p_number(double p) {
    return p < least_p ? "< 0.001" : significant(p, 2);
}

std::string share(double part, int digits) {
    const double size = std::abs(part);
    if (size > 0 && size < least_share) return "below 0.001 %";
    return significant(100 * part, digits) + " %";
}

}  // namespace tricontact::report
