#pragma once

#include <vector>

#include "experiments/identification/identification_reader.h"
#include "experiments/identification/loops/loop_fit.h"
#include "experiments/identification/measured_values.h"

namespace tricontact::experiments {

/// k_rig [N/m] of the rig in series with the contact, as what is found.
inline constexpr std::string_view rig_stiffness_key = "rig.tangential_stiffness";
/// How much more the contact carries in the last cycle of a table than in the first, over the
/// mean: no key of a case.
inline constexpr std::string_view drift_key = "friction_drift";

LoopRows rows_of(const IdentificationInput::Table& table, const MeasuredLoop& loop);
/// With these errors of the table's forces [N], which are to outlive the rows.
LoopRows rows_of(const IdentificationInput::Table& table, const MeasuredLoop& loop,
                 const std::vector<double>& errors);

/// Normal force [N] of a loop.
double load_of(const MeasuredLoop& loop, const contact::Case& rig);

/// What a contact carries in a loop over the mean of its table.
double friction_in(const IdentificationInput::Table& table, const MeasuredLoop& loop,
                   const IdentifiedRig& rig);

/// Whether loops are evaluated by the model of the layer, which then is the only one.
bool has_loops_on_layer(const IdentificationInput& input);

/// Of a sphere on a half-space, or a rigid one on a layer, under a normal force, with the rig's
/// spring. Throws InputError.
LoopCurve loop_curve(const IdentifiedRig& rig, double normal_force);

/// The curve of each loop of a table, one per load.
std::vector<LoopCurve> loop_curves(const IdentificationInput::Table& table,
                                   const IdentifiedRig& rig);

/// All loops of a table, each with its own LoopState at its best. `starts`: states nearby, or
/// empty; they become those found.
std::vector<FittedLoop> fitted_loops(const IdentificationInput::Table& table,
                                     const IdentifiedRig& rig, std::vector<LoopState>& starts);

/// Forces [N] of the table's rows by these.
std::vector<double> loop_forces(const IdentificationInput::Table& table, const IdentifiedRig& rig,
                                std::vector<LoopState>& starts);

/// Slopes of these forces by the numbers of LoopState of each loop, columns over all rows.
std::vector<std::vector<double>> loop_slopes(const IdentificationInput::Table& table,
                                             const IdentifiedRig& rig);

}  // namespace tricontact::experiments
