#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/shakedown/rolling_points.h"
#include "comparisons/shakedown/study_fit.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// One parameter of a fit of a study, for tables. The form lives as long as the study's fit.
struct FitRow {
    std::string model;
    std::string group;  ///< with the load where the fit belongs to one: "parallel, f_T = 0.8"
    const FittedForm* form = nullptr;
    std::size_t parameter = 0;
};

/// Of all fits that could be made: kappa and its plane;
std::vector<FitRow> mapping_rows(const StudyFit& fit);
/// limits, eta per load, roots.
std::vector<FitRow> ratcheting_rows(const StudyFit& fit);

/// Parts of fit_document: what the fits say in sentences,
std::vector<report::Verdict> fit_verdicts(const StudyFit& fit);

/// and in tables: fits, shifts by one kappa, models side by side. Empty tables are left out by
/// their user.
report::DocumentTable form_table(const std::string& id, const std::string& title,
                                 const std::vector<FitRow>& rows);
report::DocumentTable mapping_use_table(const StudyFit& fit);
report::DocumentTable difference_table(const StudyFit& fit);

/// Every difference of every point.
report::DocumentTable point_difference_table(const StudyFit& fit);

/// The groups of a study in the order of its points: "parallel", "parallel, thickness 8 mm", ...
std::vector<std::string> group_names(const StudyFit& fit);
/// Their models, in the order of the points.
std::vector<std::string> model_names(const StudyFit& fit);

/// One figure per group of: kappa over f_T/f_T,lim; kappa(w, f_T/f_T,lim) as a map per model,
/// linear between loads, for studies that combine at least two amplitudes with at least two settled
/// loads each; what one constant kappa leaves of f_T.
std::vector<report::Figure> mapping_figures(const StudyFit& fit);
/// What Du = c u_stat^(1/2) (w - w_lim) leaves of Du, one figure per group in which there is a fit.
std::vector<report::Figure> increment_residual_figures(const StudyFit& fit);

/// An empty curve of points with the name and colour of a model of the study.
report::Curve model_points(const std::string& model);
/// Adds a computed value and its error bar, NaN where unknown.
void add_with_bar(report::Curve& curve, double x, const Computed& value);
/// Takes the bars away if all are unknown.
void drop_unknown_bars(report::Curve& curve);

/// Where a point lies in a figure, and its bar; empty: nowhere.
using Placed = std::optional<std::pair<double, Computed>>;
using Place = std::function<Placed(const RollingPoint&)>;

/// A closed form given by x and y over a parameter. Forms of one `kind` (0, 1, ...) have one
/// colour, none of a model's.
struct Form {
    std::string name;
    double from, to;
    std::function<double(double)> x, y;
    int kind;
};

/// Figures like some of the thesis: its formulas, dashed, and the points of all models.
class ThesisFigures {
  public:
    /// Of the points of a group; empty: of all. `suffix` of ids, where a direction has several
    /// groups; amplitudes are told apart to `1/resolution`.
    ThesisFigures(const StudyFit& fit, const std::string& group, const std::string& suffix,
                  double resolution);

    /// With a curve of points for each model, if they have a place.
    report::Figure figure(const std::string& number, const std::string& title,
                          const std::string& caption, const char* x, const char* y,
                          const std::vector<Form>& forms, const Place& place = {}) const;

    std::vector<const RollingPoint*> points;
    std::set<double> amplitudes;

  private:
    const StudyFit& fit_;
    std::string group_, suffix_;
};

// Places in the figures that round bodies and line contacts have alike.

/// u_sd over f_T.
Place over_load(const Quantity& q);
/// The same from loads of `share` of the model's limit on.
Place settled_near_limit(double share);
/// w over the model's f_T,lim, once per amplitude, at all points of which it is the same.
Place amplitude_over_limit();

/// Those in which a model has points, without empty curves.
std::vector<report::Figure> with_model_points(std::vector<report::Figure> figures);

/// Figures of Wetter's thesis with its formulas drawn over the points of the models, per group
/// along (3.16, 3.17, 3.18, 3.20, 3.21) or across the rolling (3.30, 3.31, 3.32, 3.20, 3.33), as
/// far as the study has points for them. Other directions have none.
std::vector<report::Figure> thesis_figures(const StudyFit& fit);

}  // namespace tricontact::comparisons
