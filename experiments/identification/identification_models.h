#pragma once

#include <string>
#include <vector>

#include "experiments/identification/identification_report.h"
#include "experiments/identification/measured_values.h"

namespace tricontact::experiments {

/// Throws InputError where radius or thickness are to be found of a rig whose lengths are not in
/// proportion to them.
void check_lengths_scale(const IdentificationInput& input);

/// The tables and what a model finds of them, without its prediction.
IdentificationTask task_of(const IdentificationInput& input, const std::string& model);

/// What a model says about all tables, as a function of its parameters: closed forms and maps, or
/// interpolated in what its runs depend on, made when they are first needed: lengths of a
/// paraboloid on a layer are in proportion to b^2/R (heights) and b, so that E, R and b count as
/// the load F R/(E b^3) alone; beside it, mu where friction and pressure are coupled, nu where it
/// is free. `input` is to outlive it. Throws InputError (a rig whose lengths are not in
/// proportion), NotConverged.
Prediction prediction_of(const std::string& model, const IdentificationInput& input,
                         const contact::ModelRunner& runner);

/// The input's rig with these values of the model's parameters.
IdentifiedRig rig_with(const IdentificationInput& input,
                       const std::vector<FreeParameter>& parameters,
                       const std::vector<double>& values);

/// All tables, one after another, computed, not interpolated.
std::vector<double> values_of_tables(const std::string& model, const IdentificationInput& input,
                                     const IdentifiedRig& rig, const contact::ModelRunner& runner);

/// What a standard error of each input that has one does to the values found, to first order:
/// what it does to the model's values, taken off the observed ones. Of a model that states errors
/// of its shifts these follow as "atlas" and "atlas.curve": half of their variance is the same at
/// all forces, the other half goes from one sign at the least to the other at the largest.
std::vector<InputContribution> input_contributions(const std::string& model,
                                                   const IdentificationInput& input,
                                                   const IdentificationTask& task,
                                                   const Identification& found,
                                                   const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
