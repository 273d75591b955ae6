#pragma once

#include <vector>

#include "experiments/identification/identification.h"

namespace tricontact::experiments {

/// Where a sum of squares is least, and how little that is.
struct LeastSquares {
    Properties at;
    double sum = 0;
};

/// The sum of squares of an identification as a function of E and mu, and its minima along either.
/// mu is searched as q = least_friction/mu, F_T/(mu F_N) of the largest force: from 0, where
/// nothing would slip and mu does not matter, to 1, where the contact would be about to slide.
class BestSumOfSquares {
  public:
    /// Throws std::invalid_argument if the task is none.
    explicit BestSumOfSquares(const IdentificationTask& task);

    /// Infinite where the model is not defined.
    double at(const Properties& properties) const;
    /// The least sum with this value of a property, the other one at its best if it is free. Throws
    /// contact::NotConverged, contact::InputError.
    double profile(Property property, double value) const;
    /// The best of all.
    LeastSquares best() const;

    int n_free() const { return task_.young_is_free + task_.friction_is_free; }
    /// 1/variance of each observation; empty: equal.
    const std::vector<double>& weights() const { return weights_; }
    double weight(std::size_t i) const { return weights_.empty() ? 1 : weights_[i]; }

  private:
    double scaled_young(double guess, double friction) const;
    LeastSquares best_young(double friction) const;
    LeastSquares best_friction(double young) const;
    template <class Along>
    LeastSquares least_along_friction(const Along& along) const;

    const IdentificationTask& task_;
    std::vector<double> weights_;
    mutable double guess_;  // of E: the last one found
};

}  // namespace tricontact::experiments
