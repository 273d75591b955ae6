#pragma once

#include <string>
#include <vector>

#include "app/sweep_points.h"
#include "comparisons/sweep_document.h"
#include "io/result_store.h"
#include "io/study_reader.h"

namespace tricontact::app {

/// Study and results as a report tells them, with the files for ParaView that `folder` has.
comparisons::Sweep sweep_of(const io::Study& study, const std::vector<SweepPoint>& points,
                            const io::ResultStore& store, const std::string& folder);

}  // namespace tricontact::app
