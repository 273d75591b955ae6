#pragma once

#include "experiments/design/design_report.h"

namespace tricontact::app {

/// Searches what [design] asks for: assumptions by experiments::check_rig() of the values, what
/// rolling adds by the maps, the comparison's uncertainty by the maps of the most complete model
/// that they are about. Throws contact::InputError at names that the check lacks, at a quantity
/// that no map tells of the rig as it is, and where nothing within the bounds can be told.
experiments::DesignStudy design_study(const experiments::DesignInput& input);

}  // namespace tricontact::app
