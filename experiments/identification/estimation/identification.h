#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/identification/estimation/free_parameter.h"
#include "statistics/estimate.h"
#include "statistics/joint_covariance.h"
#include "statistics/outlying_rows.h"
#include "statistics/residual_correlation.h"

namespace tricontact::experiments {

/// Observations whose errors are independent and normal, of one standard deviation or of stated
/// ones.
struct ObservedTable {
    std::string name;                     ///< "static-shift"
    std::vector<double> observed;         ///< [SI]
    std::vector<double> standard_errors;  ///< [SI], one each; empty: equal, told by the residuals
    /// Observed values are counted from a place that is not known, which the fit finds.
    bool has_free_origin = false;
    /// What the observed values are plotted over: neighbours there may have errors that are alike,
    /// equal ones are repeated readings. Empty: neighbours are those of the rows.
    std::vector<double> given = {};
    /// Of each row over that of one of them, where they are told by the residuals; empty: equal.
    std::vector<double> relative_errors = {};
    /// Parts of each row's variance, over all of it, whose sizes the residuals have told, a column
    /// per part; empty: one.
    std::vector<std::vector<double>> variance_parts = {};
    /// Numbers of the table that the model itself sets to their best.
    std::size_t n_inner = 0;

    /// Numbers that the fit finds for this table alone.
    std::size_t n_own() const { return n_inner + (has_free_origin ? 1 : 0); }
};

/// Values [SI] that a model gives instead of the observed ones, those of all tables one after
/// another. Throws contact::InputError where it is not defined.
using Prediction = std::function<std::vector<double>(const std::vector<double>& values)>;

/// Tables to be explained by a model, least squares over all of them (Wetter 2016, A.1.2): what the
/// observed values are plotted over is known.
struct IdentificationTask {
    std::vector<FreeParameter> parameters;
    std::vector<ObservedTable> tables;
    Prediction model;
    double confidence = 0.95;
    /// Slopes [SI] of the model's values by the inner numbers of all tables, a column each, at
    /// these parameters; empty: none has any.
    std::function<std::vector<std::vector<double>>(const std::vector<double>& values)>
        inner_slopes = {};

    std::size_t n_observations() const;
    /// Numbers that the fit finds for the tables beside the parameters.
    std::size_t n_own() const;
};

/// By how much the observed values are best counted from elsewhere [SI], one per table; 0 where the
/// origin is known. `values`: the model's; `errors`: one per observation.
std::vector<double> origins_of(const IdentificationTask& task, const std::vector<double>& values,
                               const std::vector<double>& errors);
/// Observed values minus origin and model, over their errors.
std::vector<double> residuals_of(const IdentificationTask& task, std::vector<double> values,
                                 const std::vector<double>& errors);

/// An end at a bound of a parameter where the profile does not reach its level: 0 or what the
/// parameter cannot be below, its largest value (1/2 of Poisson's ratio) or infinity.
struct Interval {
    double low = 0, high = 0;
};

/// One parameter found. Standard error and interval are those of the linearised model, by Student's
/// t (normal: known errors); infinite if the observations do not tell, or at a bound.
struct ParameterEstimate : statistics::Estimate {
    /// All values that the likelihood ratio does not reject, other parameters at their best.
    Interval likelihood;
    double level = 0;  ///< sum of squares at its ends
};

/// How one table is explained.
struct TableFit {
    double origin = 0;                       ///< [SI] of the observed values, in the fitted ones
    std::vector<double> fitted, residuals;   ///< [SI]; observed minus fitted
    std::vector<double> fitted_half_widths;  ///< [SI] of the intervals of the fitted values
    std::vector<double> standard_errors;     ///< [SI] stated, or estimated from the residuals
    double sum_of_squares = 0;               ///< of residuals over these
    double degrees_of_freedom = 0;  ///< rows less the share of the parameters that they tell
    double r_squared = 0;           ///< (A.1.10)
    double residual_standard_deviation = 0;  ///< [SI]
    std::optional<double> goodness;          ///< P(chi^2 above this), for known errors
};

/// What the residuals of a table show that those of independent errors around a right model do not.
struct TableResiduals {
    /// Of neighbours; empty where a fit to rounding, or far within the stated errors, leaves none
    /// that matters.
    std::optional<statistics::ResidualCorrelation> correlation;
    /// P(F above this) of the curve's misfit beside the scatter of repeated readings (Draper and
    /// Smith 1998, section 2.1), where there are such.
    std::optional<double> lack_of_fit;
    bool has_pattern = false;     ///< of the one or the other, 5 % and 1 % by chance
    bool has_strong_one = false;  ///< 1 % by chance: a model is to blame, or the errors
};

/// What one model makes of the observations.
struct Identification {
    std::vector<FreeParameter> free;
    std::vector<ParameterEstimate> parameters;  ///< in their order
    std::vector<TableFit> tables;
    double sum_of_squares = 0;  ///< of residuals over their standard errors, stated or estimated
    int degrees_of_freedom = 0;
    double r_squared = 0;            ///< of all tables, weighted
    std::optional<double> goodness;  ///< P(chi^2 above this), over the tables of known errors
    double confidence = 0;
    /// Of ln v of all parameters but those at a bound, of which nothing is told.
    statistics::JointCovariance logarithmic;
    std::vector<TableResiduals> residuals;               ///< of each table
    std::vector<statistics::OutlyingRow> outlying = {};  ///< changes are relative ones
    /// By which factor, one per parameter, standard errors are those of correlated errors of
    /// neighbouring rows: of tables with a pattern; 1 without one.
    std::vector<double> widening = {};
    /// The largest factor by which they might be, of correlations that are not excluded.
    double possible_widening = 1;

    bool has_pattern() const;
    bool has_strong_pattern() const;
    std::vector<double> best() const;
    /// Place of a parameter; empty if it was not free.
    std::optional<std::size_t> find(const std::string& key, std::size_t index = 0) const;
    /// In the linearised model; empty where one of both is not told.
    std::optional<double> correlation(std::size_t i, std::size_t k) const;
    /// Sum of squares at the edge of the region of two parameters.
    double level_of_pair(std::size_t i, std::size_t k) const;
};

/// Unknown errors of each table are its residuals' root mean square over its degrees of freedom,
/// found with the parameters in turn. Throws std::invalid_argument unless something is free and
/// there are more observations than parameters, contact::InputError if the
/// model is defined nowhere near the guesses, contact::NotConverged if nothing explains the
/// observations, or a table tells its parameters but not its errors.
Identification identify(const IdentificationTask& task);

/// The best parameters for other observations, searched from those found, with their errors.
std::vector<double> best_nearby(const IdentificationTask& task, const Identification& found,
                                const std::vector<double>& observed);

/// Sum of squares with one parameter given, the others at their best.
struct Profile {
    std::vector<double> value;           ///< increasing
    std::vector<double> sum_of_squares;  ///< as Identification's
};
/// Over somewhat more than the interval of the likelihood, `n_points` values.
Profile profile_of(const IdentificationTask& task, const Identification& found, std::size_t k,
                   int n_points);

/// Sum of squares over two parameters, the first fastest; the others follow by their regression on
/// these two in the linearised model. NaN where the model is not defined.
std::vector<double> squares_of_pair(const IdentificationTask& task, const Identification& found,
                                    std::size_t first, std::size_t second,
                                    const std::vector<double>& first_values,
                                    const std::vector<double>& second_values);

}  // namespace tricontact::experiments
