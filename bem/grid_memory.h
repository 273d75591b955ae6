#pragma once

#include "bem/case_compliance.h"
#include "contact/case.h"
#include "contact/solvers/compliance.h"

namespace tricontact::bem {

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
