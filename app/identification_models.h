#pragma once

#include <string>
#include <vector>

#include "experiments/identification/identification_report.h"

namespace tricontact::app {

/// The number of the case that a key stands for; null where the case states another one instead.
double* number_of(const io::CaseKey& key, contact::Case& c);

/// Rigid shifts U [m] of a rig's indenter under its normal force and each of these tangential ones
/// [N], applied once, by a model of models.h. Throws InputError (a force reaches mu F_N),
/// NotConverged.
std::vector<double> static_shifts(const std::string& model, const contact::Case& rig,
                                  const std::vector<double>& forces, int threads);

/// What one of the models of an identification ("half-space", "layer", "atlas", "bem-layer", "fem")
/// says about a measurement on the rig, one value [SI] for each of those `given`; E and mu are the
/// rig's. Throws InputError, NotConverged.
std::vector<double> measured_values(const std::string& model,
                                    experiments::IdentificationInput::Measurement measurement,
                                    const contact::Case& rig, const std::vector<double>& given,
                                    int threads);

/// Name of the model in models.h that computes static shifts for one of an identification.
std::string shift_model(const std::string& model);

/// What a model says about the measurement, as a function of E and mu: a closed form, or
/// interpolated in E, in F_T/(mu F_N) and, where friction and pressure are coupled, in mu from runs
/// of the model, made when they are first needed. `input` is to outlive it. Throws InputError,
/// NotConverged.
experiments::Prediction prediction_of(const std::string& model,
                                      const experiments::IdentificationInput& input, int threads);

/// The input's rig with these properties.
contact::Case rig_with(const experiments::IdentificationInput& input,
                       const experiments::Properties& properties);

/// What a standard error of each input that has one does to the properties found, to first order:
/// what it does to the model's values, taken off the observed ones.
std::vector<experiments::InputContribution> input_contributions(
    const std::string& model, const experiments::IdentificationInput& input,
    const experiments::IdentificationTask& task, const experiments::Properties& best, int threads);

}  // namespace tricontact::app
