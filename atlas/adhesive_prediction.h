#pragma once

#include <string>

#include "atlas/prediction.h"

namespace tricontact::atlas {

/// Of surfaces that attract each other, which are no atlas' matter, but theory's: by formulas and
/// integrals, which know no error. The case has comparisons::adhesive_forms().
Prediction adhesive_prediction(const contact::Case& c, const std::string& model);

}  // namespace tricontact::atlas
