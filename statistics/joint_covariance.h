#pragma once

#include <vector>

namespace tricontact::statistics {

/// Rows of residuals that share one standard error.
struct ErrorGroup {
    std::size_t n_rows = 0;
    std::size_t n_own = 0;  ///< parameters of its own, with the residuals at their best
    bool is_known = true;   ///< the error was stated; else the residuals tell it
    /// Parts of each row's variance, over all of it, whose sizes the residuals tell: a column per
    /// part; empty: one of all rows.
    std::vector<std::vector<double>> parts = {};
};

/// A direction in the space of parameters, of length 1.
struct Direction {
    std::vector<double> components;
    double standard_error = 0;  ///< along it; infinite if nothing is told
};

/// What the slopes of residuals by parameters say of these, several groups of observations
/// together.
struct JointCovariance {
    std::vector<std::vector<double>> information;  ///< sum of the groups' J^T J
    /// Of what is told, all errors taken as known; pseudo-inverse.
    std::vector<std::vector<double>> covariance;
    /// The same with the uncertainty of the weights where several groups have estimated errors.
    std::vector<std::vector<double>> adjusted;
    std::vector<double> standard_errors;  ///< of `adjusted`; infinite: nothing tells a parameter
    std::vector<Direction> principal;     ///< best told first
    /// Observations of each group less the share of the parameters that it tells: these add up to
    /// all observations less the parameters that are told.
    std::vector<double> degrees_of_freedom;
    /// Of Student's t of each parameter: infinite if only groups of known errors tell it, else by
    /// what each group contributes to its variance.
    std::vector<double> effective_degrees;

    /// Variance of a parameter over that with known weights.
    double inflation(std::size_t k) const {
        return covariance[k][k] > 0 ? adjusted[k][k] / covariance[k][k] : 1;
    }
};

/// `columns`: slopes of residuals over their standard errors, a column per parameter, rows in the
/// order of the groups. A direction that is told 3e4 times worse than the best one is not told:
/// differences do not resolve it. `own`: slopes by the groups' own parameters, where variances have
/// parts.
JointCovariance joint_covariance(const std::vector<std::vector<double>>& columns,
                                 const std::vector<ErrorGroup>& groups,
                                 const std::vector<std::vector<double>>& own = {});

/// Principal directions among some of the parameters, whatever the others are.
std::vector<Direction> principal_directions(const JointCovariance& all,
                                            const std::vector<std::size_t>& among);

}  // namespace tricontact::statistics
