#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/quantities/loading_study.h"
#include "comparisons/quantities/relaxation_study.h"
#include "comparisons/resolution/numerical_error.h"
#include "comparisons/resolution/refinement.h"
#include "comparisons/run/small_strains.h"
#include "contact/case.h"
#include "contact/history.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// A file of the report, its name relative to the output folder.
struct ReportFile {
    std::string name;
    std::string content;
};

/// What a report may carry besides the histories.
struct ReportExtras {
    LoadingStudy study;
    std::optional<Refinement> refinement;           ///< of which the histories are the finest level
    RelaxationStudy relaxation;                     ///< of cases with a relaxing substrate
    std::vector<SmallStrains> small_strains;        ///< of cases at finite strains
    std::vector<report::Film> films;                ///< of models that have one
    std::vector<report::DocumentSection> sections;  ///< the caller's own, before the figures
    std::optional<NumericalError> numerical;        ///< of the last model
    std::vector<NumericalError> other_numerical;    ///< of others, see body_pair()
};
/// Of all models of which it is known.
std::vector<NumericalError> errors_of(const ReportExtras& extras);

/// The report of a run or a refinement. `resolved_case` is the case's TOML text with all defaults.
/// Histories stand in the order of the models; the others are compared with the last. Same input,
/// same document (but for the CPU times).
report::Document run_document(const contact::Case& c, const std::string& resolved_case,
                              const std::string& version,
                              const std::vector<contact::History>& histories,
                              const ReportExtras& extras = {});

/// Its report.html and the figures' files plots/*.svg, *.png, *.csv. Throws GnuplotError.
std::vector<ReportFile> report_files(const report::Document& document);

}  // namespace tricontact::comparisons
