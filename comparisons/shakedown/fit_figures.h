#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/shakedown/study_fit.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// The groups of a study in the order of its points: "parallel", "parallel, thickness 8 mm", ...
std::vector<std::string> group_names(const StudyFit& fit);
/// Their models, in the order of the points.
std::vector<std::string> model_names(const StudyFit& fit);

/// kappa over f_T/f_T,lim, one figure per group with settled points.
std::vector<report::Figure> kappa_figures(const StudyFit& fit);
/// What one constant kappa leaves of f_T, one figure per group in which there is one.
std::vector<report::Figure> kappa_residual_figures(const StudyFit& fit);
/// kappa(w, f_T/f_T,lim) as a map per model and group, linear between loads; for studies that
/// combine at least two amplitudes with at least two settled loads each.
std::vector<report::Figure> kappa_maps(const StudyFit& fit);
/// What Du = c u_stat^(1/2) (w - w_lim) leaves of Du, one figure per group in which there is a fit.
std::vector<report::Figure> increment_residual_figures(const StudyFit& fit);

/// Error bars of computed values: half widths, NaN where unknown; empty if all are.
std::vector<double> bars_of(const std::vector<Computed>& values);

}  // namespace tricontact::comparisons
