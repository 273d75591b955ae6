#pragma once

#include <string>

#include "comparisons/run/sweep_document.h"
#include "io/case/study_reader.h"
#include "report/document.h"

namespace tricontact::app {

/// A value of the table as reports want it: numbers as numbers, words as words.
report::Cell cell_of(const std::string& text);

/// An axis of a study for reports.
comparisons::Sweep::Axis axis_of(const io::Study::Axis& axis);

}  // namespace tricontact::app
