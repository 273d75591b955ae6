#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "io/case/measurement_laws.h"

namespace tricontact::experiments {

/// F_T/F_N, the largest that the contact held in static_shift without sliding; 0 without it.
double largest_held_ratio(const IdentificationInput& input);

inline constexpr std::string_view coefficient_key = "friction.coefficient",
                                  strength_key = "friction.shear_strength",
                                  exponent_key = "friction.pressure_exponent",
                                  strength_limit_key = "friction.strength_limit";
/// Whether a key is that of a number of a law of friction that tables tell.
bool is_of_law(std::string_view key);

/// mu of Coulomb's law, with a guess from the tables of shifts and of sliding.
FreeParameter coulomb_parameter(const IdentificationInput& input);

/// A number of a law, named by its key, with a guess from these tables. `law`: which numbers it
/// has, found or known.
FreeParameter law_parameter(const IdentificationInput& input, const io::MeasurementLaw& law,
                            std::string_view key);

/// Which numbers a stated law has; without a name.
io::MeasurementLaw stated_law(const contact::Friction& friction);

/// The input with a law whose numbers are found beside its parameters. The reference pressure of a
/// power is Hertz' mean pressure under the largest load and the guess of E, to one digit.
IdentificationInput with_law(const IdentificationInput& input, const io::MeasurementLaw& law);

/// Mean over the contact of what friction carries [Pa], where all slides under this force [N].
double mean_friction(bool on_layer, const contact::Case& rig, double normal_force);

/// Least and largest normal force [N] of the tables that friction enters.
struct LoadRange {
    double least = 0, largest = 0;
    double middle() const { return std::sqrt(least * largest); }
};
LoadRange loads_of_friction(const IdentificationInput& input);

}  // namespace tricontact::experiments
