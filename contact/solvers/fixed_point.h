#pragma once

#include <Eigen/Dense>
#include <deque>
#include <vector>

namespace tricontact::contact {

/// Acceleration of a fixed-point iteration x = g(x) by what the last iterates tell of g (Anderson
/// 1965; Walker and Ni 2011): the next x is the combination of the last g whose residuals g - x
/// nearly cancel. A linear contraction is solved in as many steps as it has independent modes, and
/// many an iteration that diverges by itself converges.
class FixedPoint {
  public:
    /// Of normal and tangential contact. Where all slides they multiply errors by +-i m, m = mu
    /// beta: damped, iterations gain a factor of up to m / sqrt(1 + m^2) each, combined without end
    /// m / (1 + sqrt(1 + m^2)). For m of 5 to 1e-9 that is 1000 and 100.
    static constexpr int max_iterations = 1000;

    /// The next iterate, after `g` was found at `x`; entries that are not finite are left out and
    /// taken from `g`. `residual` >= 0 measures g - x: where it has grown much, the past is
    /// forgotten and the next step is half as long.
    std::vector<double> next(const std::vector<double>& x, const std::vector<double>& g,
                             double residual);

  private:
    struct Change {
        Eigen::VectorXd residual, image;  // of the last step: in g - x, in g
    };
    std::deque<Change> changes_;
    Eigen::VectorXd last_residual_, last_image_;
    double least_ = 0, damping_ = 1;
};

/// The same of states that may be several: the first iterates are taken as they are, one after the
/// other. Where g is monotone they stay on their side of the state, so that which one is found is
/// known; then what they tell of each other is combined.
class OneSidedFixedPoint {
  public:
    static constexpr int max_iterations = 500;
    static constexpr int first = 30;  ///< iterates that are taken as they are

    std::vector<double> next(const std::vector<double>& x, const std::vector<double>& g,
                             double residual) {
        return n_++ < first ? g : accelerated_.next(x, g, residual);
    }

  private:
    int n_ = 0;
    FixedPoint accelerated_;
};

}  // namespace tricontact::contact
