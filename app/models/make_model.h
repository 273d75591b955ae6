#pragma once

#include <vector>

#include "contact/model_makers.h"
#include "contact/models/model_kind.h"

namespace tricontact::app {

/// The models of this program, the only place that knows all of them.
const contact::ModelMakers& model_makers();

/// Of the models that a case file may name, those that this program was built with.
std::vector<contact::ModelKind> known_models();

}  // namespace tricontact::app
