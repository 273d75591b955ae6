#pragma once

#include <cmath>

namespace tricontact::contact {

/// What a body conducts and keeps of heat, and how warm it is away from the contact.
struct ThermalBody {
    double conductivity = 0;   ///< lambda [W/(m K)], > 0
    double specific_heat = 0;  ///< c [J/(kg K)], > 0
    double density = 0;        ///< rho [kg/m^3], > 0
    double temperature = 0;    ///< of its bulk [degC]

    /// b = (lambda rho c)^(1/2) [W s^(1/2)/(m^2 K)].
    double effusivity() const { return std::sqrt(conductivity * density * specific_heat); }
    /// kappa = lambda/(rho c) [m^2/s].
    double diffusivity() const { return conductivity / (density * specific_heat); }
    /// Pe = v a/(2 kappa) [-] of a contact of the half length a [m] at the speed v [m/s]: way of
    /// the material over that of its heat.
    double peclet(double half_length, double speed) const {
        return speed * half_length / (2 * diffusivity());
    }
};

/// Both bodies of a contact. Kept with a case that states them, see Case::of().
struct ContactHeat {
    ThermalBody indenter, substrate;

    /// The share of heat made where they touch that flows into the substrate.
    double substrate_share() const {
        const double b = substrate.effusivity();
        return b / (indenter.effusivity() + b);
    }
    /// Of both surfaces where they touch, without friction [degC].
    double touching_temperature() const {
        return std::lerp(indenter.temperature, substrate.temperature, substrate_share());
    }
};

/// Least Pe [-] at which heat is taken to flow into the depth alone: theory::band_error is 4 %.
inline constexpr double least_peclet = 5;
/// How far heat flows into a body while it is in contact, over (kappa 2 a/v)^(1/2): of a flux
/// that lasts, a thousandth of the surface's rise is left there (Carslaw and Jaeger 1959, 2.9).
inline constexpr double heated_depth = 4;

}  // namespace tricontact::contact
