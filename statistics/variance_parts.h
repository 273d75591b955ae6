#pragma once

#include <Eigen/Core>
#include <vector>

namespace tricontact::statistics {

/// A linear model whose rows' variances are sums of parts, of which the residuals tell the sizes:
/// what restricted maximum likelihood (Patterson and Thompson 1971, Biometrika 58, 545) makes of
/// them. Rows are over their standard errors.
class VarianceParts {
  public:
    using Columns = std::vector<std::vector<double>>;

    /// `columns`: slopes by the parameters that are wanted; `own`: by numbers that are fitted
    /// beside them, which may be many and are those of few rows each; `parts`: of each row's
    /// variance, over all of it, a column per part.
    VarianceParts(const Columns& columns, const Columns& own, const Columns& parts);

    /// tr(P V_c P V_d), P = 1 - H, H the projection on all columns, V_c of the parts: twice the
    /// information of their sizes.
    const Eigen::MatrixXd& traces() const { return traces_; }
    /// tr(P V_c): what squares() are expected to be.
    const Eigen::VectorXd& expected() const { return expected_; }
    /// Of the parameters, given the weights.
    const Eigen::MatrixXd& covariance() const { return covariance_; }
    /// J' V_c J.
    const std::vector<Eigen::MatrixXd>& told() const { return told_; }
    /// Kenward and Roger's J' V_c (1 - H) V_d J, that by which uncertain weights add to the
    /// covariance.
    Eigen::MatrixXd left(std::size_t c, std::size_t d) const;
    /// r' V_c r of residuals of the best fit. `residuals`: of any.
    Eigen::VectorXd squares(const std::vector<double>& residuals) const;

  private:
    void make_traces();

    /// Orthonormal, zero but in its rows.
    struct Own {
        Eigen::Index first = 0;
        Eigen::VectorXd values;
    };
    void add_own(const std::vector<double>& column);
    Eigen::VectorXd without_own(Eigen::VectorXd column) const;

    std::vector<Own> own_;
    Eigen::MatrixXd columns_, covariance_, traces_;
    Eigen::VectorXd expected_;
    std::vector<Eigen::VectorXd> parts_;
    std::vector<Eigen::MatrixXd> told_, mixed_;  // J' V_c J, J' V_c of `own`
};

}  // namespace tricontact::statistics
