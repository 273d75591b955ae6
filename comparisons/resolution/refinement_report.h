#pragma once

#include <string>
#include <vector>

#include "comparisons/resolution/refinement.h"
#include "comparisons/run/report_tables.h"

namespace tricontact::comparisons {

/// What a refinement found, in plain sentences.
std::vector<std::string> refinement_sentences(const Refinement& refinement);

/// A row per quantity: values on all levels, order, limit, error, theory, wide block.
report::DocumentTable refinement_table(const Refinement& refinement);

/// An error in percent of a value; "-" of none.
std::string relative(double error, double value);

}  // namespace tricontact::comparisons
