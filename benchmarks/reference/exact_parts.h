#pragma once

#include <functional>

#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/plane_contact.h"
#include "benchmarks/reference/reference_kinds.h"

// What the references by exact theories of pressing have in common.
namespace tricontact::benchmarks {

/// Values of an exact theory of pressing as those of a reference that has none.
void set_exact_values(Reference& reference, const std::map<std::string, double>& exact,
                      const std::string& source);
/// The same in place of computed ones, the contact's radius included, whose differences become bars
/// of models. The stored energy stays: that of tractions is in it.
void replace_by_exact(Reference& reference, const std::map<std::string, double>& exact,
                      const std::string& source);

/// Runs springs of the method of dimensionality reduction that are exact for pressing, and notes
/// what they differ by as bars of models. A model that does not run is named in a remark.
void compare_with_springs(Reference& reference, const contact::Case& pressed,
                          const contact::ModelRunner& runner);
/// The same of boundary elements, extrapolated from three grids.
void compare_with_cells(Reference& reference, const contact::Case& pressed,
                        const contact::ModelRunner& runner);

/// Normal compliance and displaced surface, from the integrals of states under neighbouring
/// controls. `edge_slope`: of the profile at the contact's edge [-].
void add_pressing_effects(
    Reference& reference, const contact::NormalControl& control, double edge_slope,
    const std::function<EnvelopeIntegrals(const contact::NormalControl&)>& integrals_at);

/// Values of a plane contact by key.
std::map<std::string, double> exact_line_scalars(const PlaneContact& contact);
/// Its effects of pressing.
void add_line_effects(Reference& reference, const contact::NormalControl& control,
                      double half_width);

/// Bar over value; 0 of what is not there.
double relative_bar(const Reference& reference, const char* key);

}  // namespace tricontact::benchmarks
