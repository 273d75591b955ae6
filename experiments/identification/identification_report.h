#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/identification/estimation/identification.h"
#include "experiments/identification/estimation/posterior.h"
#include "experiments/identification/excluded_ranges.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/interface_comparison.h"
#include "experiments/identification/law_comparison.h"
#include "experiments/identification/loop_findings.h"
#include "report/document.h"

namespace tricontact::experiments {

/// What the standard error of a known input does to the parameters found, first order.
struct InputContribution {
    std::string key;             ///< "load.normal_force"
    double standard_error = 0;   ///< [SI]
    std::vector<double> change;  ///< of each parameter [SI] by one standard error
};

/// Sums of squares over two parameters.
struct SquaresMap {
    std::size_t first = 0, second = 0;  ///< of the parameters
    std::vector<double> x, y;           ///< their values, increasing
    std::vector<double> values;         ///< x fastest
};

/// One model of an identification: what it finds, and what is drawn of it.
struct IdentifiedModel {
    std::string name;  ///< see io::measurement_models
    Identification found;
    std::vector<Profile> profiles;  ///< one per parameter
    std::vector<SquaresMap> maps;   ///< of each two parameters
    /// Largest difference between the interpolated model and the model itself at the best
    /// values, over the largest value of a table; empty for closed forms and at the edge of
    /// sliding.
    std::optional<double> interpolation_error;
    std::vector<InputContribution> contributions;
    statistics::Correlations correlations;  ///< of the inputs, by keys
    std::optional<Posterior> posterior;     ///< if it was asked for
    /// [SI] at the points of IdentificationStudy::curve_points, of each table.
    std::vector<std::vector<double>> curves;
};

/// Standard error of a parameter [SI] from the residuals, independent of the inputs, and all inputs
/// with their correlations (Wetter 2016, A.1.4).
double combined_standard_error(const IdentifiedModel& model, std::size_t k);

/// Standard error of a parameter [SI] from the inputs alone.
double input_standard_error(const IdentifiedModel& model, std::size_t k);

/// The interval of a parameter: that of the likelihood, widened in squares by the errors of the
/// inputs, which are normal and known. Open ends stay open, bounds of a parameter are kept.
Interval full_interval(const IdentifiedModel& model, std::size_t k);

/// A measurement, and what all models make of it.
struct IdentificationStudy {
    IdentificationInput input;
    std::string title;
    std::vector<std::vector<double>> curve_points;  ///< [SI], increasing, of each table
    std::vector<IdentifiedModel> models;
    /// Laws of friction on the half-space: those of measurement.laws, of which the models have the
    /// best one; without these a strength beside Coulomb's law, where the half-space's mu is found.
    std::optional<LawComparison> laws;
    /// Beside springs of the interface that were to be found: rigid ones.
    std::optional<InterfaceComparison> interfaces;
    std::vector<TriedRange> ranges;     ///< see excluded_ranges()
    std::optional<LoopFindings> loops;  ///< by the reference model, where loops were measured
    /// Layer's thickness over the width of Hertz' contact for the values of the reference model.
    std::optional<double> thickness_ratio;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    std::string command, version;
};

/// The most complete model: finite elements before boundary elements of the layer, its maps, the
/// layer's theory, the half-space.
const IdentifiedModel& reference_model(const IdentificationStudy& study);
/// That of the half-space; the end of study.models if it is not there.
std::vector<IdentifiedModel>::const_iterator half_space_of(const IdentificationStudy& study);

/// "4.22 MPa (4.15 to 4.31)", the full interval; "above 0.12" where it is open.
std::string shown(const IdentifiedModel& model, std::size_t k);

/// The answer in sentences: the values, the half-space's bias, whether the models explain what
/// was measured, which one is to be used, what cannot be told apart or at all.
std::vector<report::Verdict> identification_verdicts(const IdentificationStudy& study);

/// "shear-strength (tau_0)".
std::string law_name(const LawFit& fit);
/// "E = 1.80 MPa (1.76 MPa to 1.84 MPa), tau_0 = 350 kPa (347 kPa to 353 kPa)".
std::string law_numbers(const LawFit& fit);
/// Which laws of friction the data support, cannot tell apart and exclude; empty if none were
/// compared.
std::vector<report::Verdict> law_verdicts(const IdentificationStudy& study);
report::DocumentTable law_table(const LawComparison& laws);
/// A table for terminals.
std::string law_lines(const LawComparison& laws);
nlohmann::ordered_json law_json(const LawComparison& laws);

/// Whether the data exclude a rigid interface; empty if no springs were to be found.
std::vector<report::Verdict> interface_verdicts(const IdentificationStudy& study);
report::DocumentTable interface_table(const InterfaceComparison& interfaces);
/// A table for terminals.
std::string interface_lines(const InterfaceComparison& interfaces);
nlohmann::ordered_json interface_json(const InterfaceComparison& interfaces);
/// "E = 1.80 MPa (1.76 MPa to 1.84 MPa)" of one of several fits, the interval of the likelihood.
std::string found_text(const Identification& found, std::size_t k);

/// Whether the intervals of a parameter of two models overlap, beside the errors of inputs that
/// both share.
bool overlap(const IdentifiedModel& a, const IdentifiedModel& b, const std::string& key,
             std::size_t index = 0);
/// Which model's values are to be used, and why; empty if there is only one.
std::optional<report::Verdict> model_to_use(const IdentificationStudy& study);
/// Chance exceeds the sum of squares so rarely that the model is to blame.
bool is_rejected(const IdentifiedModel& model);
/// The threshold of that: "p at least 0.05".
std::string rejection_text();

/// Sum of squares over the tables whose errors are stated, and its degrees of freedom.
struct ChiSquared {
    double sum = 0, degrees = 0;
};
ChiSquared chi_squared(const IdentifiedModel& model);

/// What the residuals of a model show: patterns, rows that are not where the others put them.
std::vector<report::Verdict> residual_verdicts(const IdentificationStudy& study,
                                               const IdentifiedModel& model);
/// What is assumed of the errors where these few residuals do not test it; empty where the
/// intervals hardly depend on it.
std::optional<report::Verdict> untested_independence(const IdentifiedModel& model);
/// Parameters, or ends of their intervals, of which nothing is known.
std::vector<report::Verdict> identifiability_verdicts(const IdentifiedModel& model);
/// Which ranges of the attraction the rows exclude, and what w would be over the others; empty
/// where none was tried.
std::optional<report::Verdict> range_of_adhesion(const IdentificationStudy& study);
/// That the rig states a work of adhesion, which the models leave out; empty without one.
std::optional<report::Verdict> left_out_adhesion(const IdentificationStudy& study);
/// Whether the values found are those of a short range, which their theory assumes; empty
/// for surfaces that do not attract each other.
std::optional<report::Verdict> regime_of_adhesion(const IdentificationStudy& study);

/// "layer: posterior E = 3.79 MPa (3.74 to 3.83), mu = 0.61 (0.60 to 0.62), correlation -0.97; as
/// good as 812 independent points (autocorrelation time 31 steps, 62 % accepted)."
std::string posterior_sentence(const IdentifiedModel& model);
/// Columns model and all parameters; a row per point, empty what a model has not.
std::string posterior_csv(const IdentificationStudy& study);

/// Data and models, residuals; profiles; the map of each two parameters, and points of the
/// posterior over the same axes.
std::vector<report::Figure> fit_figures(const IdentificationStudy& study);
std::vector<report::Figure> parameter_figures(const IdentificationStudy& study);

nlohmann::ordered_json identification_json(const IdentificationStudy& study);
report::Document identification_document(const IdentificationStudy& study);

}  // namespace tricontact::experiments
