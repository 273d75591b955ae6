#pragma once

#include <string>

namespace tricontact::report {

/// The probability of chance for sentences: "p = 0.23", "p < 0.001" below that.
std::string p_value(double p);
/// The same in a column headed "p": "0.23", "< 0.001"; an en dash where undefined.
std::string p_number(double p);

/// A part of a whole, or the size of a relative error, in percent: "2.3 %"; "below 0.001 %" where
/// its digits would be hard to count; an en dash where undefined.
std::string share(double part, int digits = 2);

}  // namespace tricontact::report
