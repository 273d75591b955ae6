#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "statistics/estimate.h"

namespace tricontact::experiments {

/// What an identification is after.
enum class Property { young, friction };
inline constexpr std::array both_properties{Property::young, Property::friction};

/// Something of each.
template <class Value>
struct PerProperty {
    Value young = {}, friction = {};

    Value& operator[](Property p) { return p == Property::young ? young : friction; }
    const Value& operator[](Property p) const { return p == Property::young ? young : friction; }
};
using Properties = PerProperty<double>;  ///< E of the substrate [Pa], mu [-]

/// Values [SI] that a model gives instead of the measured ones, one per observation.
using Prediction = std::function<std::vector<double>(const Properties&)>;

/// Observations to be explained by a model, least squares (Wetter 2016, A.1.2): errors of the
/// observed values are independent and normal, what they are plotted over is known.
struct IdentificationTask {
    std::vector<double> observed;         ///< [SI]
    std::vector<double> standard_errors;  ///< [SI], one each; empty: equal, told by the residuals
    Prediction model;                     ///< defined for E > 0, mu > least_friction
    Properties start;                     ///< fixed where not free; else a guess of E
    bool young_is_free = true;
    bool friction_is_free = true;
    /// Largest F_T/F_N of the observations: the contact did not slide, so mu is not below it.
    double least_friction = 0;
    double confidence = 0.95;
};

/// Where a profile does not reach its level, a bound is that of the property: 0 for E,
/// `least_friction` for mu, or infinity.
struct Interval {
    double low = 0, high = 0;
};

/// One property found.
/// Standard error and interval are those of the linearised model, by Student's t (normal: known
/// errors); infinite if the observations do not tell.
struct PropertyEstimate : statistics::Estimate {
    /// All values that the likelihood ratio does not reject, other properties at their best.
    Interval likelihood;
};

/// What one model makes of the observations.
struct Identification : PerProperty<std::optional<PropertyEstimate>> {  ///< those that were free
    Properties best;
    /// Of E and mu in the linearised model; empty unless both were free and told.
    std::optional<double> correlation;
    std::vector<double> fitted, residuals;   ///< [SI]; observed minus fitted
    std::vector<double> fitted_half_widths;  ///< [SI] of the intervals of the fitted values
    double sum_of_squares = 0;               ///< of residuals over their errors, or [SI^2]
    int degrees_of_freedom = 0;
    double r_squared = 0;                       ///< (A.1.10)
    double residual_standard_deviation = 0;     ///< [SI]; of residuals over their errors, [-]
    std::optional<double> goodness;             ///< P(chi^2 above this), for known errors
    std::array<double, 2> level_of_interval{};  ///< sums of squares at the edges of intervals, and
                                                ///< of the region of both properties
    double confidence = 0;
};

/// Largest mu over `least_friction` that is looked at; a profile still below its level there is
/// open.
inline constexpr double largest_friction_ratio = 1e3;
/// E that is looked at: from the best one over this to this times it.
inline constexpr double largest_young_ratio = 1e3;

/// Throws std::invalid_argument unless something is free and there are more observations than free
/// properties, contact::NotConverged if no E explains anything.
Identification identify(const IdentificationTask& task);

/// Sum of squares with one property given, the other at its best if it is free.
struct Profile {
    std::vector<double> value;           ///< increasing
    std::vector<double> sum_of_squares;  ///< as Identification's
};
/// Over somewhat more than the interval of the likelihood, `n_points` values.
Profile profile_of(const IdentificationTask& task, const Identification& found, Property property,
                   int n_points);

/// Sum of squares over a grid, E fastest. NaN where the model is not defined.
std::vector<double> sums_of_squares(const IdentificationTask& task,
                                    const std::vector<double>& young,
                                    const std::vector<double>& friction);

}  // namespace tricontact::experiments
