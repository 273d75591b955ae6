#pragma once

#include <cstddef>
#include <optional>
#include <string>

// Numbers in sentences, the same in every folder.

namespace tricontact::contact {

/// `digits` significant digits with trailing zeros kept, a true minus sign, powers of ten beyond
/// 1e5 and below 1e-3 ("1.20·10⁻⁷"); an en dash where undefined.
std::string significant(std::optional<double> value, int digits = 4);

/// Value and half width of its interval as the Particle Data Group rounds them: the error to two
/// digits where its leading three lie in 100 ... 354, else to one, the value to the same decimal
/// ("0.83 ± 0.12", "(1.234 ± 0.005)·10⁻⁷"). Beside an error below 1e-7 of it, or an undefined
/// one, the value has `digits` significant digits.
std::string with_error(double value, double error, int digits = 4);

/// A decimal prefix of SI.
struct UnitPrefix {
    double factor = 1;
    const char* symbol = "";
};
/// The one that keeps a magnitude between 1 and 1000.
UnitPrefix fitting_prefix(double magnitude);

/// Number and unit: "4.52 mm".
std::string quantity(double value, const std::string& base, int digits = 4);

}  // namespace tricontact::contact
