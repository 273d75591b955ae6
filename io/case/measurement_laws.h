#pragma once

#include <span>
#include <string_view>

namespace tricontact::io {

/// A law of friction that may explain measured tables, a word of `measurement.laws`: which numbers
/// of tau = min(tau_0 + mu p_r (p/p_r)^n, tau_cap) are found, the others being 0, 1 or none.
struct MeasurementLaw {
    std::string_view name;     ///< "shear-strength"
    std::string_view formula;  ///< for people: "tau_0"
    bool has_strength = false, has_coefficient = false, has_exponent = false, has_limit = false;

    int n_numbers() const { return has_strength + has_coefficient + has_exponent + has_limit; }
    /// Whether the other one, of fewer numbers, is this with the others at 0, 1 or none; a strength
    /// is also a power of n = 0, and a cap with mu without end.
    bool contains(const MeasurementLaw& other) const;
};

/// Those of few numbers first.
std::span<const MeasurementLaw> measurement_laws();
/// Throws std::out_of_range.
const MeasurementLaw& measurement_law(std::string_view name);

}  // namespace tricontact::io
