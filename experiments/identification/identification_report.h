#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/identification/identification.h"
#include "experiments/identification/identification_reader.h"
#include "experiments/identification/posterior.h"
#include "report/document.h"

namespace tricontact::experiments {

/// What the standard error of a known input does to the properties found, first order.
struct InputContribution {
    std::string key;            ///< "load.normal_force"
    double standard_error = 0;  ///< [SI]
    Properties change;          ///< of E [Pa] and mu by one standard error
};

/// Sums of squares over E and mu.
struct SquaresMap {
    std::vector<double> young, friction;  ///< increasing
    std::vector<double> values;           ///< E fastest
};

/// One model of an identification: what it finds, and what is drawn of it.
struct IdentifiedModel {
    std::string name;  ///< "half-space", "layer", "bem-layer", "fem"
    Identification found;
    PerProperty<std::optional<Profile>> profiles;  ///< of what was free
    std::optional<SquaresMap> map;                 ///< if both were free
    /// Largest difference between the interpolated model and the model itself at the best
    /// properties, over the largest value; empty for closed forms and at the edge of sliding.
    std::optional<double> interpolation_error;
    std::vector<InputContribution> contributions;
    std::optional<Posterior> posterior;  ///< if it was asked for
    std::vector<double> curve;  ///< [SI] at the points of IdentificationStudy::curve_points
};

/// Standard error of E [Pa] or mu from the residuals and all inputs, independent of each other
/// (Wetter 2016, A.1.4).
double combined_standard_error(const IdentifiedModel& model, Property property);

/// Standard error of E [Pa] or mu from the inputs alone.
double input_standard_error(const IdentifiedModel& model, Property property);

/// The interval of a property that was free: that of the likelihood, widened in squares by the
/// errors of the inputs, which are normal and known. Open ends stay open.
Interval full_interval(const IdentifiedModel& model, Property property);

/// A measurement, and what all models make of it.
struct IdentificationStudy {
    IdentificationInput input;
    std::string title;
    std::vector<double> curve_points;  ///< [SI], increasing
    std::vector<IdentifiedModel> models;
    /// Layer's thickness over the width of Hertz' contact for the E of the reference model.
    std::optional<double> thickness_ratio;
    std::vector<std::pair<std::string, std::string>> settings;  ///< name, value with unit
    std::string command, version;
};

/// The model whose properties count: the most complete one. Finite elements before boundary
/// elements of the layer, the layer's theory, the half-space.
const IdentifiedModel& reference_model(const IdentificationStudy& study);

/// "4.22 MPa (4.15 to 4.31)", the full interval; "above 0.12" where it is open.
std::string shown(const IdentifiedModel& model, Property property);

/// The answer in sentences: the properties, the half-space's bias, whether the models explain what
/// was measured, what cannot be told.
std::vector<report::Verdict> identification_verdicts(const IdentificationStudy& study);

/// "layer: posterior E = 3.79 MPa (3.74 to 3.83), mu = 0.61 (0.60 to 0.62), correlation -0.97; as
/// good as 812 independent points (autocorrelation time 31 steps, 62 % accepted)."
std::string posterior_sentence(const IdentifiedModel& model);
/// Columns model, young [Pa], friction_coefficient; a row per point.
std::string posterior_csv(const IdentificationStudy& study);

nlohmann::ordered_json identification_json(const IdentificationStudy& study);
report::Document identification_document(const IdentificationStudy& study);

}  // namespace tricontact::experiments
