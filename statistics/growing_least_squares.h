#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tricontact::statistics {

/// Least squares sum_k c_k column_k = values whose columns come one after the other, by an
/// orthogonal factorisation that grows with them: Gram and Schmidt's with each projection done
/// twice, which keeps the columns orthogonal to rounding (Giraud, Langou and Rozloznik 2005).
/// Everything that follows is known for the first n columns too, for any n.
class GrowingLeastSquares {
  public:
    explicit GrowingLeastSquares(std::vector<double> values);

    /// One entry per value. False, and nothing changed, if the column depends on those before.
    bool append(std::span<const double> column);

    std::size_t n_values() const { return values_.size(); }
    std::size_t n_columns() const { return projections_.size(); }
    /// Values minus their fit by all columns.
    const std::vector<double>& residuals() const { return residuals_; }
    /// The mean square of the leave-one-out residuals r_i/(1 - h_i) of all columns, where h_i is
    /// the leverage of value i (Allen 1974, PRESS). Infinite if a value determines a coefficient
    /// alone.
    double leave_one_out_square() const;
    /// Trace of (X^T X)^-1 of all columns X.
    double inverse_trace() const { return inverse_trace_; }

    /// Of the first n columns.
    std::vector<double> coefficients(std::size_t n) const;
    /// Of the first n columns: each value minus the fit of all others there.
    std::vector<double> leave_one_out_residuals(std::size_t n) const;

  private:
    std::vector<double> values_;
    std::vector<double> residuals_;
    std::vector<double> leverages_;
    std::vector<double> orthonormal_;           // the columns q_k, one after the other
    std::vector<std::vector<double>> factors_;  // of column k: k + 1 numbers of R
    std::vector<std::vector<double>> inverse_;  // likewise of R^-1
    std::vector<double> projections_;           // q_k . values
    double inverse_trace_ = 0;
};

}  // namespace tricontact::statistics
