#pragma once

#include <functional>
#include <vector>

#include "statistics/estimate.h"

namespace tricontact::statistics {

/// Parameters by least squares. Residuals are assumed independent, of mean zero and of equal (or,
/// with weights, known relative) variance, which is estimated from them.
struct Fit {
    std::vector<Estimate> parameters;  ///< with intervals of the fit's confidence, Student's t
    /// Of the parameters, a row each.
    std::vector<std::vector<double>> covariance;
    std::vector<double> fitted;              ///< model values, one per observation
    std::vector<double> residuals;           ///< observed minus fitted
    double residual_sum_of_squares = 0;      ///< weighted
    double explained_sum_of_squares = 0;     ///< total minus residual, weighted
    double residual_standard_deviation = 0;  ///< of an observation of weight 1
    int degrees_of_freedom = 0;              ///< observations minus parameters
    double confidence = 0;                   ///< level of the intervals

    /// R^2 = explained/total: about the mean where the model has a constant term, else about 0.
    /// NaN if the observations do not vary.
    double r_squared() const;
};

struct FitOptions {
    double confidence = 0.95;
    std::vector<double> weights =
        {};  ///< 1/variance up to a factor, one per observation; empty: equal
    /// The weights are 1/variance: nothing is estimated from the residuals, and errors are normal
    /// instead of Student's.
    bool weights_are_absolute = false;
};

/// y = sum_k parameters[k] columns[k], a column per parameter with one value per observation.
/// A column of equal nonzero values is a constant term. Throws std::invalid_argument if sizes
/// differ or there are not more observations than parameters, contact::NotConverged if columns are
/// linearly dependent.
Fit fit_linear(const std::vector<std::vector<double>>& columns, const std::vector<double>& y,
               const FitOptions& options = {});

/// Model values of all observations for given parameters; throws where it is not defined.
using FitModel = std::function<std::vector<double>(const std::vector<double>& parameters)>;

/// Parameters of a model by Levenberg's and Marquardt's method from `start`, which also gives their
/// magnitudes (no zeros). Covariance of the linearised model. Throws std::invalid_argument as
/// above, contact::NotConverged.
Fit fit_nonlinear(const FitModel& model, const std::vector<double>& y,
                  const std::vector<double>& start, const FitOptions& options = {});

}  // namespace tricontact::statistics
