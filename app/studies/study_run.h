#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/commands.h"
#include "app/studies/point_key.h"
#include "io/case/study_reader.h"
#include "io/results/result_store.h"
#include "report/document.h"

namespace tricontact::app {

/// Name of the page that the report of walking machines over two axes has beside it.
inline constexpr const char* map_page_name = "map.html";

/// What becomes of a study's points. One per kind of case; the command knows no kind.
class StudyRun {
  public:
    virtual ~StudyRun() = default;

    /// Of all points, in the order of the study.
    virtual std::vector<std::string> keys() const = 0;
    /// Computes what the store has not; `folder` is that of the sweep. Throws contact::InputError
    /// if the store cannot be written.
    virtual void compute(io::ResultStore& store, const std::string& folder) = 0;
    virtual std::string table(const io::ResultStore& store) const = 0;
    /// Without files, command and version, which are the command's.
    virtual report::Document report(const io::ResultStore& store,
                                    const std::string& folder) const = 0;
};

/// A study of contact cases: every point by every model. Checks all points' cases; throws
/// contact::InputError.
std::unique_ptr<StudyRun> contact_study(io::Study study, const Shard& shard,
                                        const SweepOptions& options);

/// The same of walking machines.
std::unique_ptr<StudyRun> walking_study(io::Study study, const Shard& shard,
                                        const SweepOptions& options);

}  // namespace tricontact::app
