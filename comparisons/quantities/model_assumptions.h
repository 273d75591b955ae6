#pragma once

#include <string>

#include "contact/case.h"

// What a model takes for granted in a case: conditions of sentences and of closed forms.
namespace tricontact::comparisons {

/// Dundurs' |beta| up to which half-spaces count as uncoupled, as bem takes them.
inline constexpr double negligible_beta = 1e-3;

/// Whether the half-spaces of the case's materials couple normal and tangential contact.
bool half_spaces_couple(const contact::Case& c);

/// Whether the model's elasticity is that of a file of influence coefficients: what the case says
/// of the bodies decides neither coupling nor thickness.
bool is_tabulated(const contact::Case& c, const std::string& model);

/// Whether the model couples normal and tangential contact in this case, or may: MDR's springs
/// never do, bem does by Dundurs' beta, or as its file of influence coefficients says.
bool couples(const contact::Case& c, const std::string& model);

/// Whether the model solves what the closed forms of uncoupled, elastic half-spaces are about.
bool is_uncoupled_half_space(const contact::Case& c, const std::string& model);

/// Whether the static shift is that of elastic bodies: always, unless the substrate relaxes. Then
/// the wait under F_T has to outlast its slowest branch, e^-7 = 1e-3 being left.
bool static_shift_is_relaxed(const contact::Case& c);

/// What the closed form of the static shift is called: "Cattaneo and Mindlin".
std::string static_theory(const contact::Case& c);

}  // namespace tricontact::comparisons
