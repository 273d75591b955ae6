#pragma once

#include <cstddef>
#include <vector>

#include "contact/substrates/relaxation.h"

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
/// Where the body's l_k are few and known, they are the poles: the error is rounding.
struct StieltjesInterpolation {
    /// `least_range` > 1. As few points as `most_error` [-] allows, in a range as wide as these do.
    StieltjesInterpolation(double least_range, double most_error);
    /// Of a body that has these l_k alone, ascending.
    StieltjesInterpolation(double least_range, std::vector<double> known_poles);

    std::size_t size() const { return nodes.size(); }
    double weight(std::size_t m, std::size_t j) const { return weights[m * size() + j]; }
    /// What X_m is multiplied by: 1/(x + pole_m), 1 where the pole is infinite.
    double factor(std::size_t m, double x) const;
    /// The share of C(node_j) in C(x).
    std::vector<double> shares(double x) const;
    /// The largest |share| of a node in an X_m at another: how far rounding is amplified.
    double amplification() const;
    /// What X_m is multiplied by where the modulus relaxes so.
    std::vector<Retardation> creep(const Relaxation& relaxation) const;

    double range, error;               ///< where the bound holds; the bound
    std::vector<double> nodes, poles;  ///< x_j > 1; >= 0
    std::vector<double> weights;       ///< row by row, see weight()

  private:
    void set_weights();
};

/// The points at which a body of this relaxation is needed, for displacements to 1e-7 at any time.
/// `known_poles`: all l_k of the body, ascending; empty: unknown. Poles that lie too close to each
/// other for rounding count as unknown.
StieltjesInterpolation interpolation_of(const Relaxation& relaxation,
                                        std::vector<double> known_poles = {});

}  // namespace tricontact::contact
