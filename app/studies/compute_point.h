#pragma once

#include <string>

#include "app/studies/sweep_points.h"
#include "app/studies/worker_pool.h"
#include "comparisons/quantities/results.h"
#include "io/results/result_store.h"

namespace tricontact::app {

/// Where the files for ParaView of a point belong, from the folder of its sweep.
std::string surface_file(const SweepPoint& point);

/// Computes a point, on one thread, and puts results, times or error into a line of text. With the
/// folder of a sweep it also writes the point's files: resolved case, history, ParaView. Throws
/// nothing.
std::string compute_point(const SweepPoint& point, const std::string& folder) noexcept;

/// What a point that did not fail gave.
comparisons::Results results_of(const io::PointOutcome& outcome);

/// What that line, or the end of the process that should have written it, says of the point.
io::PointOutcome outcome_of(const SweepPoint& point, const WorkerReport& report);

}  // namespace tricontact::app
