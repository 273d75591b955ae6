#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contact/friction/friction_law.h"
#include "contact/friction/friction_map.h"
#include "contact/friction/friction_memory.h"
#include "contact/friction/friction_rate.h"
#include "contact/friction/friction_temperature.h"

namespace tricontact::contact {

/// What a case says about its interface, in the keys of [friction]: a point that presses carries
///   tau = min(tau_0 + mu p_r (p/p_r)^n, tau_cap),
/// Coulomb's law without all but mu. A shear strength tau_0: Bowden and Tabor (1950), Briscoe and
/// Tabor (1978); n < 1: rubber, Thirion (1948), Schallamach (1952); tau_cap: Orowan (1943).
/// mu may fall with the speed of slip, which steady rolling on alone has, or with its way, and a
/// layer of [interface] may yield before the surfaces slip: those remember.
struct Friction {
    std::optional<double> coefficient;         ///< mu [-], at the pressure p_r if there is an n
    std::optional<double> shear_strength;      ///< tau_0 [Pa], else 0
    std::optional<double> pressure_exponent;   ///< n [-], else 1
    std::optional<double> reference_pressure;  ///< p_r [Pa], which n = 1 has no use for
    std::optional<double> strength_limit;      ///< tau_cap [Pa], else none
    std::optional<std::string> map_file;       ///< of `map`
    std::shared_ptr<const FrictionMap> map;    ///< of the bound over the substrate; null: the same
    std::optional<FrictionRate> rate;          ///< of what slips, from mu at rest
    std::optional<FrictionTemperature> temperature;  ///< of the surfaces, from mu when cold
    std::optional<FrictionWeakening> weakening;      ///< of what has slipped, from mu at rest
    std::optional<InterfaceYield> yield;             ///< of the layer between the surfaces

    /// Whatever slips, however fast and hot.
    bool is_coulomb() const { return is_coulomb_at_rest() && !rate && !temperature; }
    bool is_coulomb_at_rest() const {
        return !shear_strength && pressure_exponent.value_or(1) == 1 && !strength_limit && !map &&
               !weakening && !yield;
    }
    /// tau_0 wherever the surfaces touch, whatever the pressure.
    bool is_strength_alone() const {
        return shear_strength && !coefficient && !strength_limit && !map && !rate && !temperature &&
               !weakening && !yield;
    }
    /// By the way that points slip: what is carried depends on the history, and more than one state
    /// may be in equilibrium.
    bool remembers() const { return weakening || (yield && yield->hardening != 0); }
    /// Of what is at rest.
    std::shared_ptr<const FrictionLaw> law() const;
    /// With its numbers, for people: "0.35 MPa + 0.4 p".
    std::string formula() const;
    /// What a point and all of them carry, for people: "μp" and "μF_N", "τ(p)" and "F_lim" of
    /// another law than Coulomb's.
    const char* bound_symbol() const { return is_coulomb() ? "μp" : "τ(p)"; }
    const char* limit_symbol() const { return is_coulomb() ? "μF_N" : "F_lim"; }
};

}  // namespace tricontact::contact
