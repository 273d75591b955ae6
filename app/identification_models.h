#pragma once

#include <string>
#include <vector>

#include "experiments/identification/identification.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/identification_report.h"

namespace tricontact::app {

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
