#pragma once

#include <optional>

#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::runs {

struct Stiffness {
    double value = 0;   ///< dF_N/dd [N/m]
    double method = 0;  ///< half width of what presses so far apart leave [N/m]
};
/// At the normal load of a case, the hardest of a path, without friction: slope of the parabola
/// through ln F over ln d of presses at 0.6, 0.8 and 1 times it. On the elasticity that
/// `model` already has where it has siblings, else by `model` itself, which is pressed afresh and
/// has to be used for nothing else. Throws NotConverged, InputError where forces or depths are not
/// positive.
Stiffness frictionless_stiffness(const contact::Case& c, contact::Model& model);

/// F_T over U [N/m] as F_T sets in after that press, everything sticking, coupled as the model is.
/// Empty where the case has no friction or nothing holds the indenter along x: of revolution,
/// between plates. The model is used as above.
std::optional<Stiffness> sticking_stiffness(const contact::Case& c, contact::Model& model);

/// At that load the contact of a body with the upper of two unlike plates; empty of other models.
std::optional<contact::Scales> upper_contact(const contact::Case& c, const contact::Model& model);

}  // namespace tricontact::runs
