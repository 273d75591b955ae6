#pragma once

#include <optional>
#include <string>

#include "comparisons/resolution/numerical_error.h"
#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

/// "217.9 ± 1.1 µm"; without the half width where there is none, or where it is 0.
std::string value_text(double value, const char* base, std::optional<double> error);

/// Half width of the finest level's value; empty of what is not refined.
std::optional<double> refined_width(const std::optional<Refinement>& refinement, const Quantity& q);

/// What the ± behind a value is, with a blank before it: of a refined case, of a run.
std::string refinement_note(const Refinement& refinement, const Quantity& q);
std::string error_note(const std::optional<NumericalError>& error, const Quantity& q);

}  // namespace tricontact::comparisons
