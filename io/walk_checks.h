#pragma once

#include "dynamics/walk_case.h"
#include "io/toml_document.h"

namespace tricontact::io {

/// Throws contact::InputError at a machine that is both dimensionless and dimensional.
void check_one_kind(const Document& document);

/// Throws contact::InputError at lists of [spots] that do not fit each other or the model.
void check_spots(const dynamics::WalkCase& c, const Document& document);

/// Throws contact::InputError where the numbers of a resolved case do not fit together: a step
/// beyond the stable limit, a start in units that are zero ...
void check_walk_case(const dynamics::WalkCase& c, const Document& document);

}  // namespace tricontact::io
