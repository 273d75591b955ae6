#pragma once

#include <memory>

#include "contact/case.h"
#include "contact/model.h"

namespace tricontact::bem {

/// What the boundary elements take the substrate for.
enum class Body { half_space, layer };

/// Boundary elements for a case: the grid covers the contact along its whole rolling
/// path and is enlarged until it does. `n_threads`: for the transforms; results do not depend on
/// it. Throws contact::InputError if the grid would be too large.
std::unique_ptr<contact::Model> make_model(const contact::Case& c, int n_threads,
                                           Body body = Body::half_space);

}  // namespace tricontact::bem
