#pragma once

#include <string>
#include <vector>

#include "experiments/identification/identification_reader.h"
#include "io/keys/input_file.h"

namespace tricontact::experiments {

/// What the reader of an identification refuses about friction loops: they stand alone, for a
/// half-space, and find friction.
void check_loop_tables(const IdentificationInput& input, const std::vector<std::string>& find,
                       const io::Document& document);

/// Loads stand in the rows of all tables of loops, or in load.normal_force.
void check_loop_loads(const IdentificationInput& input, const io::Document& document);

/// 1/k_rig [m/N] of [rig], in series with the contact of loops; 0: rigid, or there are none.
double compliance_of_rig(const IdentificationInput& input, const io::Document& document);

/// E [Pa] of the substrate whose contact is twice as stiff as the loops at their reversals.
double guessed_young_of_loops(const IdentificationInput::Table& table, double radius,
                              double normal_force);

/// The same of a line contact of this length [m].
double guessed_young_of_lines(const IdentificationInput::Table& table, double length);

/// Largest half range of force over normal force.
double largest_ratio_of_loops(const IdentificationInput::Table& table, double normal_force);

/// k_rig: not below a part of the stiffness that the loops show.
FreeParameter rig_stiffness_parameter(const IdentificationInput& input);

/// A linear drift of friction over the cycles is found beside friction where a series has three
/// cycles at least; empty: none has.
std::vector<FreeParameter> drift_parameters(const IdentificationInput& input);

}  // namespace tricontact::experiments
