#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "comparisons/quantities/relaxation_study.h"
#include "comparisons/run/report_tables.h"
#include "report/figure.h"

namespace tricontact::comparisons {

// Of cases with a relaxing substrate.

/// How the substrate relaxes, whether it may be taken as elastic, and what the fit to a DMA table
/// is worth, in plain sentences.
std::vector<std::string> relaxation_sentences(const contact::Case& c, const RelaxationStudy& study);

/// The difference of one model from its elastic reference run in a sentence; empty if it has none.
std::string twin_sentence(const TwinComparison& twin);

/// Drive values, Deborah numbers and errors of the elastic reference run, a column per model.
report::DocumentTable relaxation_table(const contact::Case& c, const RelaxationStudy& study);

/// G' and G'' over the frequency with drive and limit; beside a DMA table's points, if the case has
/// one, and their residuals.
std::vector<report::Figure> modulus_figures(const contact::Case& c, const RelaxationStudy& study);

/// The section "relaxation" of summary.json.
nlohmann::ordered_json relaxation_json(const contact::Case& c, const RelaxationStudy& study);

}  // namespace tricontact::comparisons
