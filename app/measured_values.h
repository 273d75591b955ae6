#pragma once

#include <string>
#include <vector>

#include "contact/case.h"
#include "experiments/identification/identification_reader.h"

namespace tricontact::app {

/// Rigid shifts U [m] of a rig's indenter under its normal force and each of these tangential ones
/// [N], applied once, by a model of models.h. Throws InputError (a force reaches mu F_N),
/// NotConverged.
std::vector<double> static_shifts(const std::string& model, const contact::Case& rig,
                                  const std::vector<double>& forces, int threads);

/// What one of the models of an identification ("half-space", "layer", "bem-layer", "fem") says
/// about a measurement on the rig, one value [SI] for each of those `given`; E and mu are the
/// rig's. Throws InputError, NotConverged.
std::vector<double> measured_values(const std::string& model,
                                    experiments::IdentificationInput::Measurement measurement,
                                    const contact::Case& rig, const std::vector<double>& given,
                                    int threads);

/// Name of the model in models.h that computes static shifts for one of an identification.
std::string shift_model(const std::string& model);

}  // namespace tricontact::app
