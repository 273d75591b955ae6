#pragma once

#include "contact/history.h"
#include "contact/model.h"

namespace tricontact::contact {

/// A model pressed without friction, and its limit of shakedown.
struct FrictionlessLimit {
    Scales scales;                ///< upright
    double tangential_ratio = 0;  ///< f_T,lim = (1/F_N) ∫ min p dA
};

/// The least pressures over the case's path, whose steps press and roll without friction. The model
/// is at rest before. The loads must be constant. Throws NotConverged, ContactAtEdge, InputError.
FrictionlessLimit frictionless_limit(const Case& c, Model& model);

/// The case with F_T/(mu F_N) in place of `load.limit_fraction` or `load.limit_excess`, this
/// model's frictionless limit being known; others as they are. The model is at rest before and
/// after it. Throws as frictionless_limit(), and InputError where the limit is 0.
Case loaded_by_own_limit(const Case& c, Model& model);

/// The same where the model has run: other runs beside it have its F_T.
Case loaded_as(const Case& c, const History& history);

}  // namespace tricontact::contact
