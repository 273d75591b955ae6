#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "contact/case.h"
#include "contact/history.h"
#include "report/derived_value.h"

namespace tricontact::comparisons {

/// What is known in closed form, or by one integral, of the case's surfaces that attract each
/// other: of bodies of revolution on a half-space, of a range above 0 paraboloids under Dugdale's
/// law alone (Maugis 1992).
struct AdhesiveForms {
    double contact_radius = 0;  ///< under the normal load of the case [m]
    double indentation = 0;     ///< likewise [m]
    double normal_force = 0;    ///< likewise [N]
    contact::PullOff pull_off;
    /// Of a shear strength alone, over the contact: what it carries, tau_0 pi a^2 [N], and the
    /// shift at which it begins to slide, 2 tau_0 a/G* [m]; else NaN.
    double friction_limit = 0, unit_shift = 0;
    std::string theory;  ///< "Johnson, Kendall and Roberts"
};
/// Empty where nothing is.
std::optional<AdhesiveForms> adhesive_forms(const contact::Case& c);

/// Equilibria of the case on a half-space by a theory, stable or not, over their contact radius.
struct AdhesiveEquilibria {
    std::string theory;
    /// Indentation [m] and force [N] of a radius above 0 [m].
    std::function<contact::Vector2(double radius)> at;
};
/// By the theory of adhesive_forms() first; of a range above 0 also by those of no range and of a
/// long one, between which it lies. None where there is no theory.
std::vector<AdhesiveEquilibria> adhesive_equilibria(const contact::Case& c);

/// Tabor's parameter (R w^2/(E*^2 range^3))^(1/3) of a round body [-]; infinite of the range 0;
/// empty without adhesion and of other bodies.
std::optional<double> tabor_parameter(const contact::Case& c);

/// These numbers with symbols and units, for those who check a case; none without adhesion.
std::vector<report::DerivedValue> adhesive_values(const contact::Case& c);

/// Which regime the case is in, and what it asks of cells and elements; empty without adhesion.
std::vector<std::string> adhesion_sentences(const contact::Case& c);

}  // namespace tricontact::comparisons
