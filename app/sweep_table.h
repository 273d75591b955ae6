#pragma once

#include <string>
#include <vector>

#include "app/sweep_points.h"
#include "io/result_store.h"
#include "io/study_reader.h"

namespace tricontact::app {

/// The results as CSV: a row per point in the order of the study, the varied keys in SI units,
/// model, level, results and error. The same points give the same bytes, however they came about.
std::string sweep_table(const io::Study& study, const std::vector<SweepPoint>& points,
                        const io::ResultStore& store);

}  // namespace tricontact::app
