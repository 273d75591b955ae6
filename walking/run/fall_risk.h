#pragma once

#include <span>

#include "walking/machine/machine.h"
#include "walking/machine/walk_record.h"

namespace tricontact::walking {

/// How often a motion like that of these windows is to be expected to pass tilting_limit in a time
/// `times` as long: from the tail of the windows' greatest |phi|, which above their median is taken
/// to fall off exponentially; that of a bounded or of a normally distributed motion falls faster.
/// Infinite where |phi| rises from window to window and would be there at this rate.
double expected_falls(const Machine& machine, std::span<const WalkWindow> windows, double times);

}  // namespace tricontact::walking
