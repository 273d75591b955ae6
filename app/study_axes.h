#pragma once

#include <string>

#include "comparisons/document.h"
#include "comparisons/sweep_document.h"
#include "io/study_reader.h"

namespace tricontact::app {

/// A value of the table as reports want it: numbers as numbers, words as words.
comparisons::Cell cell_of(const std::string& text);

/// An axis of a study for reports.
comparisons::Sweep::Axis axis_of(const io::Study::Axis& axis);

}  // namespace tricontact::app
