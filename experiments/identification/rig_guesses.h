#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "io/keys/toml_document.h"

namespace tricontact::experiments {

inline constexpr double guessed_plane_share = .75;  ///< E/E* of a rigid indenter

/// The first one that tells it.
const IdentificationInput::Table& table_of_young(const IdentificationInput& input);

/// E by Hertz' theory of an incompressible half-space from the row of the largest value [Pa]; mu
/// infinite, relaxed.
double guessed_young(const IdentificationInput::Table& table, double radius, double normal_force);

/// Of a table without tangential forces [N].
double largest_force(const IdentificationInput::Table& table);

/// mu of the shifts and the sliding that were measured, larger than what held.
double guessed_friction(const IdentificationInput& input, double normal_force);

/// Strengths of a law that are found: such that the case is one, since the search has starts of its
/// own. `ratio`: guessed_friction(); `young` [Pa].
std::vector<std::pair<std::string_view, io::Value>> guessed_law(
    const std::vector<std::string>& find, const io::Document& rig, double ratio, double young,
    double radius, double normal_force);

}  // namespace tricontact::experiments
