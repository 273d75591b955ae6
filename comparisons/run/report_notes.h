#pragma once

#include <string>

#include "contact/case.h"

// Notes of the report: what its columns and symbols mean for a case.
namespace tricontact::comparisons {

std::string derived_note(const contact::Case& c);
std::string results_note(const contact::Case& c, bool several_models);
std::string rolling_note(const contact::Case& c);
std::string layer_note(const contact::Case& c);
std::string variants_note(const contact::Case& c);

inline constexpr const char* audit_paragraph =
    "Every step of every model was checked; the table shows the worst violation of the whole run, "
    "dimensionless. A run with a failed check does not end normally.";

inline constexpr const char* sources =
    "R. Wetter, The Interplay of System Dynamics and Dry Friction: Shakedown, Ratcheting and "
    "Micro-Walking (thesis, TU Berlin) · Mindlin and Deresiewicz (1953), J. Appl. Mech. 20 · "
    "Johnson (1985), Contact Mechanics";

}  // namespace tricontact::comparisons
