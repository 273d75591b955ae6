#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "contact/base/fftw.h"
#include "contact/base/memory.h"
#include "contact/compliances/active_operator.h"

// u(i) = sum over j of K(i - j) t(j): docs/explanation/models/bem.md. Conventions, N = period:
//
//   forward   f^(m) = sum over j of f(j) exp(-2 pi i j m/N)         FFTW_FORWARD, r2c
//   backward  f(j)  = sum over m of f^(m) exp(+2 pi i j m/N)        FFTW_BACKWARD, c2r
//
// neither with a factor: backward after forward gives N f. The factor 1/(N_x N_y) is part of the
// symbol, and products need none. The wave number of m is 2 pi m/N up to m = N/2 and 2 pi (m - N)/N
// beyond (`wrapped`). Along x the fields are real, f^(-m) = f^(m)*, and m = 0 ... N_x/2 are kept.
//
// Zeros beside a field keep the images of its period away from it: with N_x >= 2 n_x - 1 the
// positions i - j = -(n_x - 1) ... n_x - 1 are all different modulo N_x.
//
//        n_x     zeros                 1. rows:     r2c of the n_y rows that hold something
//     +-------+-----------+            2. columns:  zeros appended, forward, times the symbols,
//     | field |           | n_y           backward, eight columns at a time: they stay in the cache
//     +-------+-----------+            3. rows:     c2r of the n_y rows that are read
//     |     never touched |
//     +-------+-----------+ N_y        `tile`: the layout of memory between 1 and 2, and 2 and 3
//
// A kernel even under (x, y) -> (-x, -y) has a real symbol: K_xx, K_xy, K_yy, K_zz. One odd there
// has an imaginary one: K_xz, K_yz. What is stored of it is the imaginary part s, and `phase`
// multiplies by i ("forward", u_x and u_y by p) or by -i ("backward", u_z by t_x and t_y: the
// adjoint, since K_zx at a position is K_xz at the opposite one).
//
// The kernel at half a period stands for both signs of that position: the mean of both is taken
// (`fourier_coefficients`). Only even periods have such an element, and no product of a padded
// field reads it.

namespace tricontact::bem {

/// Smallest even number >= n whose only prime factors are 2, 3, 5, 7: lengths FFTW is fast at.
int good_fft_size(int n);
/// The same without 9 as a factor: of complex transforms, FFTW's estimated plans take 1.6 times as
/// long per number where it is one.
int good_complex_fft_size(int n);

using contact::FftwComplex, contact::FftwPlan, contact::FftwReal;

/// Convolution of fields on an n_x * n_y grid (x fastest) with kernels K(-x, -y) = K(x, y), which
/// are real in Fourier space, or K(-x, -y) = -K(x, y), which are imaginary there. The transforms
/// are pruned: rows that hold only zeros or that are not read are not transformed. Plans are
/// estimated, not measured, and work is split into fixed pieces, so results do not depend on timing
/// or on the number of threads. One caller at a time: products of a const object share scratch.
///
/// With period_x >= 2 n_x - 1 (and y) the convolution is linear; with less it is periodic.
class GridConvolution {
  public:
    /// Transform of a kernel, scaled by 1/(period_x period_y): one real number (of an odd kernel:
    /// its imaginary part) per wave vector, k_y fastest.
    using Symbol = std::vector<double>;
    enum class Parity { even, odd };  ///< under (x, y) -> (-x, -y)
    /// Symmetric 2x2 matrix per wave vector.
    struct Symbol2 {
        Symbol xx, xy, yy;
    };
    /// Period of rows, at least n, that suits its real transforms along x; those along y are
    /// complex.
    static int row_period(int n) { return good_fft_size(n); }

    GridConvolution(int n_x, int n_y, int period_x, int period_y, int n_threads);

    int n_x() const { return n_x_; }
    int n_y() const { return n_y_; }
    int period_x() const { return period_x_; }
    int period_y() const { return period_y_; }
    int n_threads() const { return n_threads_; }

    Symbol zero_symbol() const {
        return contact::large_field(static_cast<std::size_t>(period_y_) * pitch_, n_threads_);
    }

    /// Symbol of the kernel with values coefficient(i, j) at the relative position of i, j cells
    /// (either sign).
    Symbol symbol(const std::function<double(int, int)>& coefficient,
                  Parity parity = Parity::even) const;

    /// Symbol of the kernel with these Fourier coefficients at the wave numbers 2 pi m_x/period_x,
    /// 2 pi m_y/period_y, m_x >= 0: of an even kernel, or the imaginary ones of an odd one.
    Symbol symbol_of_coefficients(const std::function<double(int, int)>& coefficient) const;

    /// Symbols of kernels K_ij, all even or all odd.
    template <std::size_t n_out, std::size_t n_in>
    using Kernels = std::array<std::array<const Symbol*, n_in>, n_out>;
    template <std::size_t n>
    using Fields = std::array<std::span<double>, n>;
    template <std::size_t n>
    using ConstantFields = std::array<std::span<const double>, n>;
    enum class Phase { none, forward, backward };  ///< 1, i, -i: times a sum of real symbols

    /// out_i = sum_j K_ij * in_j of one or two fields of n_x * n_y values, which may overlap, with
    /// even kernels, or `forward` odd ones, or `backward` minus these: the adjoint.
    template <std::size_t n_out, std::size_t n_in, Phase phase = Phase::none>
    void apply(const Kernels<n_out, n_in>& kernels, const ConstantFields<n_in>& in,
               const Fields<n_out>& out) const;

  private:
    static constexpr int piece = 8;  // rows or columns per FFTW call

    struct Rows {  // a piece of them, padded
        FftwReal values;
        FftwComplex spectrum;
    };
    struct Columns {
        FftwComplex values, spectrum;
    };
    FftwComplex make_spectrum() const;
    /// Of a spectrum: a piece of columns, the rows of which are one after the other. What is
    /// transformed by rows and by columns then lies in long runs of memory for both.
    fftw_complex* tile(fftw_complex* spectrum, int row, int column) const {
        return spectrum + static_cast<std::size_t>(column) * n_rows_ +
               static_cast<std::size_t>(row) * piece;
    }
    void rows_forward(std::span<const double> in, fftw_complex* spectrum) const;
    void rows_backward(fftw_complex* spectrum, std::span<double> out) const;
    void columns_forward(const fftw_complex* tile, const Columns& to) const;
    void columns_backward(const Columns& from_spectrum, fftw_complex* tile) const;
    const Columns& columns_of(int thread, int component) const;
    template <typename Body>  // (first row or column, number of the thread)
    void for_each_piece(int n, Body body) const;

    const int n_x_, n_y_, period_x_, period_y_, n_threads_;
    const int n_rows_;                 // n_y rounded up to whole pieces
    const int pitch_;                  // of the spectrum's rows, >= period_x/2 + 1, whole pieces
    mutable FftwComplex spectrum_[2];  // of all rows, see tile(); per component
    mutable std::vector<Rows> rows_;   // per thread
    mutable std::vector<Columns> columns_;  // per thread and component
    FftwPlan row_forward_, row_backward_, column_forward_, column_backward_;
};

/// Inverse matrix per wave vector; where a truncated kernel is not positive definite, its diagonal.
GridConvolution::Symbol2 inverse(GridConvolution::Symbol2 symbol, int n_threads = 1);
/// The inverse of what has the inverse `bare`, with the same `layer` added per wave number.
GridConvolution::Symbol2 inverse_under(const contact::LayerCompliance& layer,
                                       const GridConvolution::Symbol2& bare, int n_threads);

}  // namespace tricontact::bem
