#pragma once

#include <string>

#include "app/sweep_points.h"
#include "app/worker_pool.h"
#include "io/result_store.h"

namespace tricontact::app {

/// Computes a point, on one thread, and puts results, times or error into a line of text. Throws
/// nothing.
std::string compute_point(const SweepPoint& point) noexcept;

/// What that line, or the end of the process that should have written it, says of the point.
io::PointOutcome outcome_of(const SweepPoint& point, const WorkerReport& report);

}  // namespace tricontact::app
