#pragma once

#include <string>
#include <utility>
#include <vector>

#include "comparisons/shakedown/mapping_fit.h"
#include "comparisons/shakedown/model_differences.h"
#include "comparisons/shakedown/ratcheting_fit.h"
#include "comparisons/shakedown/rolling_points.h"
#include "report/document.h"

namespace tricontact::comparisons {

/// What a sweep over amplitudes and loads says of kappa, eta and the differences of models.
struct StudyFit {
    std::string title;
    std::string command;                                        ///< that makes it again
    std::string version;                                        ///< of the program
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    double confidence = 0.95;
    const theory::RolledLaw* law = &theory::coulomb_rolling;  ///< of friction, of all points
    std::string caveat;  ///< why the fits are not those of the theory; empty: they are
    std::vector<RollingPoint> points;
    std::vector<MappingGroup> mapping;
    std::vector<RatchetingGroup> ratcheting;
    std::vector<ModelDifference> differences;
};

/// Adds what follows from points and confidence.
void evaluate(StudyFit& fit);

/// Of a study on a relaxing substrate: its numbers belong to this drive and rest.
std::string relaxing_caveat();

/// fit.json: all of it, ratios dimensionless, undefined numbers null.
std::string fit_json(const StudyFit& fit);

/// fits.csv: a row per parameter of a fit: model, group, form, parameter, value, standard error,
/// interval, sums of squares and R^2 of the form's left side as in the thesis' table A.1.1, R^2
/// about zero of what the parameters multiply, number of observations, degrees of freedom, caveat.
std::string fits_csv(const StudyFit& fit);

/// points.csv: a row per point of a model: model, group, w, f_T, state, then each result and
/// its numerical error, both empty where undefined; the caveat.
std::string points_csv(const StudyFit& fit);

/// Verdicts, tables and figures, those of the thesis with its formulas over the models.
report::Document fit_document(const StudyFit& fit);

/// Settled shifts, limits and increments of a study of line contacts beside the exact solution on
/// the half-space (theory/oscillating_cylinder.h) and the thesis' fits, its figures 3.40 and 3.43
/// to 3.46. `shift_factor`: lambda of all its cases, contact::line_shift_factor().
report::Document line_fit_document(const StudyFit& fit, double shift_factor);

}  // namespace tricontact::comparisons
