#pragma once

#include <vector>

#include "contact/base/gauss_legendre.h"

namespace tricontact::theory {

/// Quadrature over 0 < x < a, split where a function loses its smoothness. Positions on a piece are
/// x = begin + length s^2, s Gauss points, so that sqrt(x - begin) is smooth too; on the first
/// piece x = length s.
class LineMesh {
  public:
    /// `breaks`: increasing, positive; those at or beyond the radius a [m] do not count.
    LineMesh(double radius, const std::vector<double>& breaks, int points_per_piece);

    double radius() const { return ends_.back(); }
    int size() const { return static_cast<int>(positions_.size()); }
    const std::vector<double>& positions() const { return positions_; }  ///< x [m], increasing
    const std::vector<double>& weights() const { return weights_; }      ///< [m]

  private:
    friend class LineLoad;
    contact::QuadratureRule rule_;
    std::vector<double> ends_;  // 0, breaks, a
    std::vector<double> positions_, weights_;
};

/// An even line load q(x) [N/m], |x| <= a, which stands for axisymmetric pressure: a Legendre
/// series on each piece of its mesh.
class LineLoad {
  public:
    /// `values`: q at the mesh's positions.
    LineLoad(LineMesh mesh, const std::vector<double>& values);

    /// q(x) [N/m] at 0 <= x <= a.
    double value(double x) const;

    /// ∫_0^x q dx [N] at 0 <= x <= a: half the force on a strip of the half width x; exact for the
    /// series.
    double integral(double x) const;

    /// Pressure p(r) [Pa] at r >= 0, zero for r >= a:
    ///   pi p(r) = q(r)/sqrt(a^2 - r^2) + ∫_r^a [q(r) - q(x)] x/(x^2 - r^2)^(3/2) dx,
    /// which is -∫ q'(x)/sqrt(x^2 - r^2) dx by parts and holds for q(a) > 0, too (then it is
    /// singular at the edge). Popov and Hess (2015), eq. 3.37.
    double pressure(double r) const;

  private:
    int piece_of(double x) const;

    LineMesh mesh_;
    std::vector<double> coefficients_;  // of the Legendre polynomials, piece by piece
};

}  // namespace tricontact::theory
