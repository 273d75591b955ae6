#pragma once

#include "benchmarks/reference/reference.h"

namespace tricontact::app {

/// Whether a case rolls on and has no closed form: its reference is the steady state of boundary
/// elements, which only the program can roll.
bool has_rolling_reference(const contact::Case& c);

/// That state on three grids, each half as coarse as the one before: resultants and creepage
/// extrapolated, fields of the finest with what the finest two differ by as their bar. Throws
/// contact::InputError, contact::NotConverged.
benchmarks::Reference rolling_reference(const contact::Case& c, int n_threads);

}  // namespace tricontact::app
