#pragma once

#include "contact/model_makers.h"
#include "experiments/design/design_report.h"

namespace tricontact::experiments {

/// Searches what [design] asks for: assumptions by check_rig() of the values, what
/// rolling adds by the maps, the comparison's uncertainty by the maps of the most complete model
/// that they are about. Throws contact::InputError at names that the check lacks, at a quantity
/// that no map tells of the rig as it is, and where nothing within the bounds can be told.
DesignStudy design_study(const DesignInput& input, const contact::ModelRunner& runner);

}  // namespace tricontact::experiments
