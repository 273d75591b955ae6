#pragma once

#include "io/keys/toml_document.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking {

/// Throws contact::InputError at a machine that is both dimensionless and dimensional.
void check_one_kind(const io::Document& document);

/// Throws contact::InputError at lists of [spots] that do not fit each other or the model.
void check_spots(const WalkCase& c, const io::Document& document);

/// Throws contact::InputError where the numbers of a resolved case do not fit together: a step
/// beyond the stable limit, a start in units that are zero ...
void check_walk_case(const WalkCase& c, const io::Document& document);

}  // namespace tricontact::walking
