#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/compliances/compliance.h"

namespace tricontact::rolling {

/// Wiener-Hopf factors of a matrix function of one wave number, `behind` times `ahead`: Fourier
/// sums over n >= 0 alone, and over n <= 0 alone. One matrix per wave number 2 pi m/N, the
/// coefficient of n being sum over m of (...) exp(2 pi i m n/N)/N: by rows.
struct RowFactors {
    using Matrix = std::array<std::complex<double>, 4>;
    std::vector<Matrix> behind, ahead;
};
/// Of symmetric matrices: the cepstrum of the root of their determinant, Hermitian up to that
/// scalar (Wilson 1972, matricial spectral densities, whose Newton steps end after a few).
RowFactors factorised(const std::vector<RowFactors::Matrix>& symbol);

/// An approximate inverse of steady rolling among points that stick,
///   M = -d/dx A = (1 - T) A/h,   T f(x) = f(x + h).
/// A, a convolution, is B F: B reads what is behind a point, F what is ahead of it. On a strip
/// without a trailing edge M = B (F (1 - T)/h) among its points exactly, both factors triangular:
///   M^-1 = F^-1 J B^-1,   J the sum of h times all from the leading edge on,
/// each of them among the points that stick: tractions begin like a root at the leading edge, as in
/// the finite Hilbert transform that M is (Muskhelishvili 1953, ch. 11). A^-1 J is singular there.
class StickInverse {
  public:
    /// Made when first applied, from the displacements that tractions on the corners of the grid
    /// cause. `compliance` shall outlive it.
    explicit StickInverse(const contact::Compliance& compliance) : compliance_(compliance) {}

    /// f on the points where `sticks` becomes M^-1 f, all else zero.
    void apply(const std::vector<std::uint8_t>& sticks, contact::TangentialField& f) const;

  private:
    using Symbol = std::vector<RowFactors::Matrix>;  ///< per wave vector, scaled by the period
    struct Factors;
    struct DeleteFactors {
        void operator()(Factors* factors) const;
    };

    const contact::Compliance& compliance_;
    mutable std::unique_ptr<Factors, DeleteFactors> factors_;
};

}  // namespace tricontact::rolling
