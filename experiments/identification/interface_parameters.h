#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

inline constexpr const char *normal_stiffness_key = "interface.normal_stiffness",
                            *tangential_stiffness_key = "interface.tangential_stiffness";

/// A key of [interface].
bool is_stiffness(std::string_view key);

/// The softest springs [Pa/m] that the tables allow: all of a depth, radius or shift is theirs.
/// `modulus`: a guess of E* [Pa], where no table tells; `normal_force`: of shifts without a column
/// of it.
double softest_stiffness(const IdentificationInput& input, std::string_view key, double radius,
                         double modulus, double normal_force);

/// k_n or k_t [Pa/m], searched in its reciprocal, so that a rigid interface is at an end of it.
FreeParameter stiffness_parameter(const IdentificationInput& input, const std::string& key);

/// Where the search starts if the case says nothing [Pa/m].
double guessed_stiffness(double softest);

}  // namespace tricontact::experiments
