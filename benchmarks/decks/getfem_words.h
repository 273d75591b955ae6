#pragma once

#include <string>

#include "benchmarks/decks/deck_model.h"

namespace tricontact::benchmarks {

inline constexpr const char* getfem_version = "GetFEM 5.4.2";

/// The weak form of linear elasticity in GetFEM's language: of la, mu and u.
const char* getfem_elasticity(const DeckModel& model);

/// The "r" of a formula replaced by another expression.
std::string with_radius(const std::string& formula, const std::string& expression);

}  // namespace tricontact::benchmarks
