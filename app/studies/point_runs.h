#pragma once

#include <functional>
#include <string>

#include "app/studies/study_kind.h"
#include "io/results/result_store.h"

namespace tricontact::app {

/// How points are computed.
struct PointRuns {
    std::string name;           ///< of the command, before its progress
    int jobs = 1;               ///< processes side by side
    bool retry_failed = false;  ///< points whose failure the store has
    bool quiet = false;         ///< no progress
    std::string folder = {};    ///< of the sweep, if points write files of their own (ParaView)
    std::function<void()> attend = {};  ///< called while points are computed; may throw
};

/// The store in the folder of a sweep, for writing; says on standard error if rows of it were
/// damaged and are computed again. Throws contact::InputError.
io::ResultStore open_results(const std::string& folder);

/// Computes the points that the store has not yet, or whose files are asked for and not there, in
/// processes side by side, each lot stored as it ends; prints how far it is. The BLAS of the
/// processes has one thread each. Throws contact::InputError if the store cannot be written.
void compute_missing(const StudyKind& kind, const StudyPoints& points, io::ResultStore& store,
                     const PointRuns& runs);

}  // namespace tricontact::app
