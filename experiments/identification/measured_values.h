#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contact/load_path.h"
#include "contact/model_makers.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::experiments {

/// A rig with what was found of it.
struct IdentifiedRig {
    contact::Case as_case;
    double pivot_height = 0;  ///< Dh over the contact [m]
    /// Of each table of force_indentation: where the contact begins [m]; empty: at 0.
    std::vector<double> zero_depths = {};
    bool shifts_by_theory = false;  ///< see IdentificationInput
    double rig_compliance = 0;      ///< 1/k_rig [m/N], 0: rigid
    bool loops_on_layer = false;    ///< or on a half-space
    /// Of friction from the first cycle of a table to the last, over the mean.
    double friction_drift = 0;
};

/// Rigid shifts U [m] of a rig's indenter under its normal force and each of these tangential ones
/// [N], applied once, by a model of models.h. Throws InputError (a force reaches mu F_N),
/// NotConverged.
std::vector<double> static_shifts(const std::string& model, const contact::Case& rig,
                                  const std::vector<double>& forces,
                                  const contact::ModelRunner& runner);

/// Standard errors of these shifts that the model itself states [m]: of the maps, by their bars;
/// empty: none.
std::vector<double> static_shift_errors(const std::string& model, const contact::Case& rig,
                                        const std::vector<double>& forces);

/// False for the half-space's closed forms, which have no such coupling.
bool is_coupled(const std::string& model, const contact::Case& rig,
                const contact::ModelRunner& runner);

/// dU/dW [-] of free rolling with this amplitude [m], which is 0 unless normal and tangential
/// contact are coupled: along the drive, after the
/// first periods, by a model of models.h.
double own_wobble(const std::string& model, const contact::Case& rig, double amplitude,
                  const contact::ModelRunner& runner);
double largest_offset(const std::vector<double>& offsets);
/// Shifts that follow the drive, U = W (own wobble + Dh/R) (Wetter 2016, 5.1.11).
std::vector<double> rolled_shifts(const IdentifiedRig& rig, double own_wobble,
                                  const std::vector<double>& offsets);

/// By one of the models of an identification; atlas and bem-layer stand for the exact theory of
/// the layer. Throws InputError, NotConverged.
std::vector<Pressed> presses(const std::string& model, const contact::Case& rig,
                             const std::vector<contact::NormalControl>& controls,
                             const contact::ModelRunner& runner);

/// The rig whose substrate is relaxed, as slow measurements find it.
contact::Case relaxed(contact::Case c);

/// How the rig is pressed for the rows of a table: one press of each, or a single one that relaxes.
std::vector<contact::NormalControl> controls_of(const IdentificationInput::Table& table,
                                                const contact::Case& rig,
                                                const std::vector<double>& given);
/// What the table shows of these presses [SI].
std::vector<double> values_of_presses(const IdentificationInput::Table& table,
                                      const contact::Case& rig, const std::vector<double>& given,
                                      const std::vector<Pressed>& all);

/// Values of a table, by the rows in contact: depths count from its zero_depth, and where there is
/// no contact there is no force, nor a radius without a force.
std::vector<double> from_zero_depth(
    const IdentificationInput::Table& table, const IdentifiedRig& rig,
    const std::vector<double>& given,
    const std::function<std::vector<double>(const std::vector<double>&)>& values);

/// What one of the models of an identification (see io::measurement_models)
/// says about a table's measurement on the rig, one value [SI] for each of those `given`. A
/// substrate of the rig that relaxes is relaxed but in histories. `given` are the table's own where
/// it states normal forces. Throws InputError, NotConverged.
std::vector<double> measured_values(const std::string& model,
                                    const IdentificationInput::Table& table,
                                    const IdentifiedRig& rig, const std::vector<double>& given,
                                    const contact::ModelRunner& runner);

/// Name of the model in models.h that computes static shifts for one of an identification.
std::string shift_model(const std::string& model);

}  // namespace tricontact::experiments
