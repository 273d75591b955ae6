#pragma once

#include <vector>

namespace tricontact::contact {

/// How the compliance of an elastic body depends on the modulus of a part of it: with x a factor of
/// some of its stiffness (its shear moduli, say, while bulk moduli stay),
///   C(x) = sum c_k/(x + l_k),   all c_k positive semidefinite, 0 <= l_k <= infinity,
/// whatever the body's shape (l_k: the generalised eigenvalues of the rest in that part). Hence
/// the rational interpolation
///   C(x) = sum_m X_m/(x + pole_m),   X_m = sum_j weight(m, j) C(node_j),
/// at Zolotarev's points, best for all l_k at once, converges exponentially, and its error is
/// bounded without knowledge of the body:
///   |C(x) - exact| <= error * exact   for 1 <= x <= range, in the energy of any load.
/// Zolotarev (1877); Braess (1986), Nonlinear Approximation Theory, V.5.
class StieltjesInterpolation {
  public:
    /// `range` > 1. As few points as `error` [-] allows, in a range as wide as these do.
    StieltjesInterpolation(double range, double error);

    std::size_t size() const { return nodes_.size(); }
    const std::vector<double>& nodes() const { return nodes_; }  ///< x_j > 1
    const std::vector<double>& poles() const { return poles_; }  ///< > 0
    double error() const { return error_; }                      ///< the bound
    double range() const { return range_; }                      ///< where it holds
    double weight(std::size_t m, std::size_t j) const { return weight_[m * size() + j]; }
    /// The share of C(node_j) in C(x).
    std::vector<double> shares(double x) const;

  private:
    std::vector<double> nodes_, poles_, weight_;
    double error_ = 0, range_ = 1;
};

}  // namespace tricontact::contact
