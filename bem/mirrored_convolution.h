#pragma once

#include <functional>
#include <span>
#include <vector>

#include "bem/grid_convolution.h"

namespace tricontact::bem {

/// GridConvolution of fields that y = 0 mirrors, on the rows y >= 0: a single field is even in y;
/// of two, the first is even and the second odd. As f = even + i odd obeys f(x, -y) = f(x, y)*, one
/// complex transform of half of the rows and half of the columns does the work of four real ones of
/// them all. One caller at a time.
class MirroredConvolution {
  public:
    using Symbol = GridConvolution::Symbol;  ///< of the wave numbers k_y >= 0 only
    using Parity = GridConvolution::Parity;
    using Phase = GridConvolution::Phase;

    /// Period of rows, at least n.
    static int row_period(int n) { return good_complex_fft_size(n); }

    /// `n_y` rows, the first at y = 0; the periods are those of the whole plane's 2 n_y - 1 rows.
    MirroredConvolution(int n_x, int n_y, int period_x, int period_y, int n_threads);

    int period_x() const { return period_x_; }
    int period_y() const { return period_y_; }
    int n_threads() const { return n_threads_; }

    /// As GridConvolution's.
    Symbol symbol(const std::function<double(int, int)>& coefficient,
                  Parity parity = Parity::even) const;

    /// As GridConvolution's. Kernels xx, yy, zz are even in x and in y, xy is odd in both, xz odd
    /// in x, yz odd in y.
    template <std::size_t n_out, std::size_t n_in, Phase phase = Phase::none>
    void apply(const GridConvolution::Kernels<n_out, n_in>& kernels,
               const GridConvolution::ConstantFields<n_in>& in,
               const GridConvolution::Fields<n_out>& out) const;
    /// The same of several kernels with one transform of what they have in common, `out` of each.
    template <std::size_t n_out, std::size_t n_in>
    void apply_each(std::span<const GridConvolution::Kernels<n_out, n_in>> kernels,
                    const GridConvolution::ConstantFields<n_in>& in,
                    std::span<const GridConvolution::Fields<n_out>> out) const;

  private:
    struct Plans {
        FftwPlan forward, backward;
    };
    /// Pieces of rows and columns; `row` and `column` are padded with zeros.
    struct Workspace {
        FftwComplex row, row_back, column, column_spectrum, column_back;
    };
    fftw_complex* row(int j) const {
        return spectrum_.get() + static_cast<std::size_t>(j) * period_x_;
    }
    template <std::size_t n_in>
    void rows_forward(const GridConvolution::ConstantFields<n_in>& in) const;
    template <std::size_t n_out>
    void rows_backward(const GridConvolution::Fields<n_out>& out) const;
    template <std::size_t n_out, std::size_t n_in>
    void multiply_columns(const GridConvolution::Kernels<n_out, n_in>& kernels, int first, int n,
                          const fftw_complex* from, fftw_complex* to) const;
    const Plans& columns_plans(int n) const;
    void gather_columns(int first, int n, fftw_complex* columns) const;
    void scatter_columns(const fftw_complex* columns, int first, int n) const;
    template <typename Body>  // (first row or column, number of the thread)
    void for_each_piece(int n, Body body) const;

    const int n_x_, n_y_, period_x_, period_y_, n_threads_;
    const int n_kx_, n_ky_;               // wave numbers >= 0
    FftwComplex spectrum_;                // of the rows, whole pieces
    mutable FftwComplex whole_spectrum_;  // column by column, where several kernels share it
    std::vector<Workspace> workspaces_;   // per thread
    Plans by_rows_, by_columns_, by_last_columns_;  // of a piece, or what is left of one
};

}  // namespace tricontact::bem
