#pragma once

#include <string>
#include <string_view>

namespace tricontact::io {

/// Physical dimensions of case files.
enum class Dimension {
    none,
    length,
    pressure,
    force,
    angle,
    time,
    velocity,
    viscosity,
    frequency,
    angular_frequency,
    mass,
    density,
    stiffness,
    acceleration,
    moment_of_inertia,
    rotation_per_length,
    energy_per_area,
    thermal_conductivity,
    temperature_coefficient,
    wear_rate,
    area,
    energy,
    pressure_per_length,
    specific_heat,
    temperature  ///< in degC
};

std::string_view name_of(Dimension dimension);     ///< "a length"
std::string_view si_unit(Dimension dimension);     ///< "m", "Pa", "N", "rad"
std::string_view example_of(Dimension dimension);  ///< "40 mm"

/// A quantity that cannot be read: `rule` is broken, `remedy` helps.
struct QuantityError {
    std::string rule;
    std::string remedy;
};

/// Value in SI units of a number with a unit, such as "40 mm" or "90 deg"; UDUNITS-2 knows the
/// units. Independent of the locale, thread safe. Throws QuantityError; throws contact::InputError
/// when the unit database is missing.
double parse_quantity(std::string_view text, Dimension dimension);

}  // namespace tricontact::io
