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
                   .has_limit = true}};

}  // namespace

// All laws of two numbers become Coulomb's (tau_0 = 0, n = 1, tau_cap without end) and a strength
// (mu = 0, n = 0, mu without end).
bool MeasurementLaw::contains(const MeasurementLaw& other) const {
    return other.n_numbers() == 1 && n_numbers() == 2;
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
