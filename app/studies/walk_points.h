#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/case/study_reader.h"
#include "io/results/result_store.h"
#include "walking/machine/walk_case.h"

namespace tricontact::app {

/// One point of a study of walking machines.
struct WalkPoint {
    std::vector<std::string> values = {};  ///< one per axis of the study, as in the table
    walking::WalkCase c = {};              ///< without title
    std::string resolved = {};             ///< text of the case
    std::string key = {};                  ///< digest of program version and case
};

/// All combinations of the study's lists, ranges and sample, the last axis fastest. All cases pass
/// the checks of case files: the first that does not is named with its values. Throws
/// contact::InputError.
std::vector<WalkPoint> walk_points(const io::Study& study);

/// How they are computed.
struct WalkRuns {
    int jobs = 1;                       ///< processes side by side
    bool retry_failed = false;          ///< points whose failure the store has
    bool quiet = false;                 ///< no progress
    std::function<void()> attend = {};  ///< called while points are computed; may throw
};

/// Computes the points that the store has not yet, some dozens at a time in the lanes of the
/// processor's vectors, each lot stored as it ends; prints how far it is. What a point comes to
/// depends neither on its lot nor on the jobs. Throws
/// contact::InputError if the store cannot be written.
void compute_missing(const std::vector<WalkPoint>& points, io::ResultStore& store,
                     const WalkRuns& runs);

}  // namespace tricontact::app
