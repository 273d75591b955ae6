#pragma once

#include <string>
#include <vector>

#include "app/studies/sweep_points.h"
#include "comparisons/run/sweep_document.h"
#include "io/case/study_reader.h"
#include "io/results/result_store.h"

namespace tricontact::app {

/// Study and results as a report tells them, with the files for ParaView that `folder` has.
comparisons::Sweep sweep_of(const io::Study& study, const std::vector<SweepPoint>& points,
                            const io::ResultStore& store, const std::string& folder);

}  // namespace tricontact::app
