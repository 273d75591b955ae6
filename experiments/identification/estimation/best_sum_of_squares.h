#pragma once

#include <optional>
#include <vector>

#include "experiments/identification/estimation/identification.h"
#include "statistics/bounded_least_squares.h"

namespace tricontact::experiments {

/// The sum of squares of an identification over the coordinates of its parameters, and its minima.
class BestSumOfSquares {
  public:
    /// Unknown errors begin as equal parts of what each table holds. Throws std::invalid_argument
    /// if the task is none.
    explicit BestSumOfSquares(const IdentificationTask& task);
    /// With these errors, one per observation.
    BestSumOfSquares(const IdentificationTask& task, std::vector<double> standard_errors);

    /// Of observed minus fitted values over their errors. Throws contact::NotConverged when they
    /// have been asked for most_evaluations times: a search that finds no end.
    std::vector<double> residuals(const std::vector<double>& x) const;
    /// Infinite where the model is not defined.
    double at(const std::vector<double>& x) const;
    /// From several starts over the ranges of mu and nu, with all else at its guess; unknown
    /// errors are estimated from the tables in turn. Throws contact::InputError where the model is
    /// not defined at any start, contact::NotConverged.
    statistics::BoundedFit best();
    /// From one start, with the errors as they are.
    statistics::BoundedFit best_from(const std::vector<double>& x) const;
    /// The least sum with one coordinate held, searched from `x`.
    statistics::BoundedFit profile(std::size_t k, double coordinate, std::vector<double> x) const;

    const statistics::Bounds& bounds() const { return bounds_; }
    const std::vector<double>& standard_errors() const { return errors_; }
    /// Of ln v at x; parameters at a bound tell nothing.
    statistics::JointCovariance covariance(const std::vector<double>& x) const;
    /// Slopes of residuals by ln v, a column per parameter.
    std::vector<std::vector<double>> logarithmic_slopes(const std::vector<double>& x) const;
    /// The same, and a column per free origin of a table and per inner number.
    std::vector<std::vector<double>> all_slopes(const std::vector<double>& x) const;
    /// These alone.
    std::vector<std::vector<double>> own_slopes(const std::vector<double>& x) const;

  private:
    /// Largest relative change of an error; `left`: rows of each table beside the parameters that
    /// it tells, see statistics::JointCovariance::degrees_of_freedom.
    double estimate_errors(const std::vector<double>& x, const std::vector<double>& left);

    const IdentificationTask& task_;
    std::vector<double> observed_, errors_;
    statistics::Bounds bounds_;
    mutable long n_evaluations_ = 0;
};

/// Searches and profiles of four parameters take some ten thousand; so many of closed forms or
/// interpolated curves take some ten seconds.
inline constexpr long most_evaluations = 1'000'000;

}  // namespace tricontact::experiments
