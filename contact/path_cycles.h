#pragma once

#include <cstddef>
#include <vector>

#include "contact/history.h"
#include "contact/prescribed_path.h"

namespace tricontact::contact {

/// A closed cycle of a path: rows at which its drive turns back, all that is prescribed being the
/// same at `begin` and `end`.
struct PathCycle {
    std::size_t begin = 0, turn = 0, end = 0;
};

/// The cycles of a path, one after the other, the last one as late as there is one: from a reversal
/// of the drive to the next but one, or to the last row. The drive is force or shift along x, where
/// that is constant that along y, else the rotation. Empty where nothing turns back, or never to
/// where it was.
std::vector<PathCycle> closed_cycles(const PrescribedPath& path);

/// These, or, of a path that has none, those from one end of its rolling to the other and back.
std::vector<PathCycle> repeated_cycles(const PrescribedPath& path);

/// The last step at each row of a prescribed path; null where a row was never a step's end: the
/// first one of a path that starts unloaded.
std::vector<const StepRecord*> steps_at_rows(const History& history);

}  // namespace tricontact::contact
