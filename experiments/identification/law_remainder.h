#pragma once

#include <string>

#include "contact/model_makers.h"
#include "experiments/identification/law_comparison.h"

namespace tricontact::experiments {

/// What the wider law may be beside the narrower one that it contains, under the geometric mean of
/// the loads, at the ends of the intervals of its numbers: "tau_0 up to 12 kPa, 21 % of friction".
/// Empty if that is little (negligible_part). Throws contact::InputError, contact::NotConverged.
std::string what_is_left(const std::string& model, const LawFit& narrow, const LawFit& wide,
                         const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
