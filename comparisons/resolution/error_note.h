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

/// Half widths of a field of the last state where it is drawn: " ± 3.1 % of τ over all (L2), 0.4
/// μp_0 at the worst point, on the contact's edge: what mesh and steps leave in BEM." Empty of
/// other models than that of the bars, and where there are none. `field` as of FieldBar; `unit`
/// that it is drawn over, in SI, and what that is called.
std::string field_note(const std::optional<NumericalError>& error, const std::string& model,
                       const std::string& field, double unit, const std::string& unit_name);

}  // namespace tricontact::comparisons
