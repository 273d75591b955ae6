#pragma once

#include <memory>

#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "contact/solvers/compliance.h"
#include "contact/vector2.h"

namespace tricontact::bem {

/// The case's hardest normal control over its mean.
double hardest_factor(const contact::Case& c);

/// Whether the grid of the compliance holds the contact wherever the case's path takes it, `extent`
/// [m] to either side: probed by the hardest press where the path reaches farthest, and, where
/// friction moves the contact aside and `with_friction` is set, by the largest tangential force.
bool covers(const contact::Compliance& compliance, const contact::Case& c,
            const std::shared_ptr<const contact::Indenter>& indenter,
            const contact::Vector2& extent, bool with_friction);

}  // namespace tricontact::bem
