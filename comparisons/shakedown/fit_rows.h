#pragma once

#include <string>
#include <vector>

#include "comparisons/shakedown/study_fit.h"

namespace tricontact::comparisons {

/// One fit of a study, for tables. The form lives as long as the study's fit.
struct FitRow {
    std::string model;
    std::string group;  ///< with the load where the fit belongs to one: "parallel, f_T = 0.8"
    const FittedForm* form = nullptr;
};

/// All fits that could be made: kappa, its plane, limits, eta per load, roots.
std::vector<FitRow> fit_rows(const StudyFit& fit);

/// Those of kappa only, or of ratcheting and limits only.
std::vector<FitRow> mapping_rows(const StudyFit& fit);
std::vector<FitRow> ratcheting_rows(const StudyFit& fit);

}  // namespace tricontact::comparisons
