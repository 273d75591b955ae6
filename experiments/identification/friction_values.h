#pragma once

#include <functional>
#include <span>
#include <vector>

#include "contact/solvers/control.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// Rows of a table of shifts that were measured under one normal force.
struct LoadedRows {
    double normal_force = 0;         ///< [N]
    std::vector<std::size_t> rows;   ///< of the table
    std::vector<double> given = {};  ///< of these: F_T [N]
};
/// In the order of increasing forces; all rows under the rig's where the table states none.
std::vector<LoadedRows> rows_by_load(const IdentificationInput::Table& table,
                                     const contact::Case& rig, const std::vector<double>& given);

/// Values of the rows, from those of each load's, which `values` gives for the load's rig and
/// forces; empty where it gives none. `given` are the table's own where it states normal forces.
std::vector<double> by_load(
    const IdentificationInput::Table& table, const contact::Case& rig,
    const std::vector<double>& given,
    const std::function<std::vector<double>(const contact::Case& rig,
                                            const std::vector<double>& given)>& values);

/// A contact pressed without friction [N, m].
struct Pressed {
    double normal_force = 0, contact_radius = 0, indentation = 0;
};
/// On a half-space, with the springs of the rig's interface.
Pressed half_space_press(const contact::Case& rig, const contact::NormalControl& control);

/// Shifts [m] of a rig under any law of friction and any interface, one force [N] after another
/// applied to it: on a half-space, or on a layer where is_beyond_coulomb(). Above what the law
/// carries they go on rising, as the law's do below it, so that a search comes back from there.
std::vector<double> theory_shifts(bool on_layer, const contact::Case& rig,
                                  const std::vector<double>& forces);

/// Forces [N] at which all slides: mu F_N, of other laws than Coulomb's under the pressure on a
/// half-space or a layer, with the springs of the interface; 0 where nothing presses.
std::vector<double> sliding_forces(bool on_layer, const contact::Case& rig,
                                   const std::vector<double>& normal_forces);

}  // namespace tricontact::experiments
