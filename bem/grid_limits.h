#pragma once

#include <memory>

#include "bem/model.h"
#include "contact/base/vector2.h"
#include "contact/bodies/indenter.h"
#include "contact/case.h"
#include "contact/compliances/compliance.h"

namespace tricontact::bem {

/// Whether the grid of the compliance holds the contact wherever the case's path takes it, `extent`
/// [m] to either side: probed by the hardest press where the path reaches farthest, and, where
/// friction moves the contact aside and `with_friction` is set, by the largest tangential force.
bool covers(const contact::Compliance& compliance, const contact::Case& c,
            const std::shared_ptr<const contact::Indenter>& indenter,
            const contact::Vector2& extent, bool with_friction);

/// What lies beside a grid: nothing, where convolutions need it padded, or its images.
enum class Surroundings { free, periodic };

/// Memory that a model of the case takes on a grid [bytes], to some 20 percent: what the
/// convolutions hold, and by their number the fields of solvers, states and records
/// (tests/unit/bem/grid_memory.cc).
double predicted_bytes(const contact::Case& c, Body body, Surroundings surroundings,
                       const contact::ContactPoints& grid);

/// The same of a table of influence coefficients of a whole period.
double influence_bytes(const contact::ContactPoints& whole);

/// Throws contact::InputError where the grid needs more than there is.
void require_memory(const contact::ContactPoints& grid, double bytes);

}  // namespace tricontact::bem
