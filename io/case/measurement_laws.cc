#include "io/case/measurement_laws.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace tricontact::io {

namespace {

constexpr std::array laws{
    MeasurementLaw{.name = "coulomb", .formula = "mu p", .has_coefficient = true},
    MeasurementLaw{.name = "shear-strength", .formula = "tau_0", .has_strength = true},
    MeasurementLaw{.name = "strength-and-coulomb",
                   .formula = "tau_0 + mu p",
                   .has_strength = true,
                   .has_coefficient = true},
    MeasurementLaw{.name = "power",
                   .formula = "mu p_r (p/p_r)^n",
                   .has_coefficient = true,
                   .has_exponent = true},
    MeasurementLaw{.name = "capped",
                   .formula = "min(mu p, tau_cap)",
                   .has_coefficient = true,
                   .has_limit = true},
    MeasurementLaw{.name = "strength-and-power",
                   .formula = "tau_0 + mu p_r (p/p_r)^n",
                   .has_strength = true,
                   .has_coefficient = true,
                   .has_exponent = true}};

}  // namespace

bool MeasurementLaw::contains(const MeasurementLaw& other) const {
    if (other.n_numbers() >= n_numbers()) return false;
    const bool frees_all = has_strength >= other.has_strength &&
                           has_coefficient >= other.has_coefficient &&
                           has_exponent >= other.has_exponent && has_limit >= other.has_limit;
    const bool is_strength = !other.has_coefficient && !other.has_limit;
    return frees_all || (is_strength && (has_exponent || has_limit));
}

std::span<const MeasurementLaw> measurement_laws() {
    return laws;
}

const MeasurementLaw& measurement_law(std::string_view name) {
    const auto found = std::ranges::find(laws, name, &MeasurementLaw::name);
    if (found == laws.end())
        throw std::out_of_range("no law of friction of measurements: " + std::string(name));
    return *found;
}

}  // namespace tricontact::io
