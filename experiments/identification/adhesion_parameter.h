#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "io/keys/input_file.h"

namespace tricontact::experiments {

/// Work of adhesion w [J/m^2], as what is found.
inline constexpr std::string_view work_key = "adhesion.work";
/// Work of approach w_a, found as a share of w, w_r = w_a/w [-].
inline constexpr std::string_view approach_key = "adhesion.approach_work";

/// What the reader refuses of surfaces that attract each other: depths, radii and forces of full
/// sliding alone tell it, by half-space and layer.
void check_adhesive_tables(const IdentificationInput& input, const std::vector<std::string>& find,
                           const io::Document& document);

/// Over an area under tension a strength alone is a law of friction.
void check_adhesive_friction(const IdentificationInput& input, const io::Document& document);

/// w by Johnson, Kendall and Roberts' pull-off from the largest tension of the tables [J/m^2];
/// without one, from what their least force would hide.
double guessed_work(const IdentificationInput& input, double radius);

FreeParameter work_parameter(const IdentificationInput& input);
FreeParameter approach_parameter();

/// Leaves the rows of a table of depths that are evaluated. Those of other tables are in contact.
/// Throws contact::InputError for rows that are not in the order of time. `name`: for messages.
void keep_adhesive_rows(IdentificationInput::Table& table, const std::string& name);

}  // namespace tricontact::experiments
