#include "bem/mirrored_convolution.h"

#include <omp.h>

#include <algorithm>

#include "bem/fourier_coefficients.h"

// f = even + i odd on the rows y >= 0 has f(x, -y) = f(x, y)*. Three things follow for its
// transform F, with k' = (k_x, -k_y) the mirror image of k:
//
//   F(-k_x, k_y) = F(k_x, k_y)*                        half of the wave numbers k_x are enough
//   even^(k) = [F(k) + F(k')]/2                        one complex transform serves two real fields
//   odd^(k)  = [F(k) - F(k')]/(2 i)
//
// The first is the sum over f exp(-i k x) with y replaced by -y. In `multiply` a kernel that is
// even in k_y acts on both parts alike; K_xy, odd in k_x and k_y, swaps them: in terms of F(k) and
// F(k') that is the mean (xx + yy)/2, the half difference, and i xy with the signs of both wave
// vectors.

namespace tricontact::bem {

namespace {

constexpr int lines = 8;  // rows or columns per FFTW call

int whole_pieces_of_lines(int n) {
    return (n + lines - 1) / lines * lines;
}

/// A complex number as a vector.
using Complex = double __attribute__((vector_size(16)));

Complex load(const fftw_complex& c) {
    return Complex{c[0], c[1]};
}
void store(fftw_complex& c, const Complex& value) {
    c[0] = value[0];
    c[1] = value[1];
}
Complex times_i(const Complex& c) {
    return Complex{-c[1], c[0]};
}

/// What a wave vector k makes of f at k and at its mirror image k', f = even + i odd.
struct Pair {
    Complex here, there;
};

using Phase = GridConvolution::Phase;

// Derived from even^ and odd^ above, t = (even, odd) and K per wave vector:
//   xx even^ + xy odd^ = new even^,   xy even^ + yy odd^ = new odd^,
// and F' of the new field at k and k' by F = even^ + i odd^, F' = even^ - i odd^.
template <std::size_t n_out, std::size_t n_in>
Pair multiply(const double* const (&s)[n_out][n_in], int k, const Pair& f) {
    if constexpr (n_out == 1 && n_in == 1) {
        return {s[0][0][k] * f.here, s[0][0][k] * f.there};
    } else if constexpr (n_out == 2 && n_in == 2) {
        // xx, xy, yy of the even and the odd part, (f + f')/2 and (f - f')/2i; xy is odd in k_y.
        const double xx = s[0][0][k], xy = s[0][1][k], yy = s[1][1][k];
        const double mean = (xx + yy) / 2, half = (xx - yy) / 2;
        return {mean * f.here + half * f.there + xy * times_i(f.there),
                mean * f.there + half * f.here - xy * times_i(f.here)};
    } else if constexpr (n_out == 2) {
        // i xz and i yz of an even field; yz is odd in k_y.
        const double xz = s[0][0][k], yz = s[1][0][k];
        return {xz * times_i(f.here) - yz * f.here, xz * times_i(f.there) + yz * f.there};
    } else {
        const double xz = s[0][0][k] / 2, yz = s[0][1][k] / 2;
        const Complex sum = -xz * times_i(f.here + f.there) - yz * (f.here - f.there);
        return {sum, sum};
    }
}

FftwComplex zeros(std::size_t n) {
    return contact::fftw_zeros<FftwComplex>(n);
}

}  // namespace

MirroredConvolution::MirroredConvolution(int n_x, int n_y, int period_x, int period_y,
                                         int n_threads)
    : n_x_(n_x),
      n_y_(n_y),
      period_x_(period_x),
      period_y_(period_y),
      n_threads_(n_threads),
      n_kx_(period_x / 2 + 1),
      n_ky_(period_y / 2 + 1),
      spectrum_(zeros(static_cast<std::size_t>(whole_pieces_of_lines(n_y)) * period_x)) {
    for (int k = 0; k < n_threads; ++k) {
        auto piece = [](int period) { return zeros(static_cast<std::size_t>(lines) * period); };
        workspaces_.push_back(
            {piece(period_x), piece(period_x), piece(period_y), piece(period_y), piece(period_y)});
    }
    // Out of place FFTW's estimated plans take two thirds of the time.
    auto plans = [](int period, const FftwComplex& from, const FftwComplex& to, int n) {
        auto plan = [&](int sign) {
            return FftwPlan(fftw_plan_many_dft(1, &period, n, from.get(), nullptr, 1, period,
                                               to.get(), nullptr, 1, period, sign, FFTW_ESTIMATE));
        };
        return Plans{plan(FFTW_FORWARD), plan(FFTW_BACKWARD)};
    };
    const Workspace& work = workspaces_.front();
    by_rows_ = plans(period_x, work.row, work.row_back, lines);
    by_columns_ = plans(period_y, work.column, work.column_spectrum, lines);
    const int rest = n_kx_ % lines;
    if (rest > 0) by_last_columns_ = plans(period_y, work.column, work.column_spectrum, rest);
}

MirroredConvolution::Symbol MirroredConvolution::symbol(
    const std::function<double(int, int)>& coefficient, Parity parity) const {
    const Symbol whole =
        fourier_coefficients(period_x_, period_y_, coefficient, parity, n_threads_);
    Symbol half(static_cast<std::size_t>(n_kx_) * n_ky_);
    for (int i = 0; i < n_kx_; ++i)
        std::copy_n(whole.begin() + static_cast<std::ptrdiff_t>(i) * period_y_, n_ky_,
                    half.begin() + static_cast<std::ptrdiff_t>(i) * n_ky_);
    return half;
}

template <typename Body>
void MirroredConvolution::for_each_piece(int n, Body body) const {
    if (n_threads_ == 1) {
        for (int first = 0; first < n; first += lines) body(first, 0);
        return;
    }
#pragma omp parallel for num_threads(n_threads_) schedule(static)
    for (int first = 0; first < n; first += lines) body(first, omp_get_thread_num());
}

/// Of the mirrored rows too: f(k_x, -y) = f(-k_x, y)*. What pads the columns stays zero.
void MirroredConvolution::gather_columns(int first, int n, fftw_complex* columns) const {
    for (int j = 0; j < n_y_; ++j) {
        const fftw_complex* const from = row(j);
        for (int i = 0; i < n; ++i) {
            fftw_complex* const column = columns + static_cast<std::size_t>(i) * period_y_;
            const int k = first + i;
            store(column[j], load(from[k]));
            if (j == 0) continue;
            const fftw_complex& opposite = from[k == 0 ? 0 : period_x_ - k];
            column[period_y_ - j][0] = opposite[0];
            column[period_y_ - j][1] = -opposite[1];
        }
    }
}

void MirroredConvolution::scatter_columns(const fftw_complex* columns, int first, int n) const {
    for (int j = 0; j < n_y_; ++j) {
        fftw_complex* const to = row(j);
        for (int i = 0; i < n; ++i) {
            const fftw_complex* const column = columns + static_cast<std::size_t>(i) * period_y_;
            const int k = first + i;
            store(to[k], load(column[j]));
            if (k == 0 || 2 * k == period_x_) continue;
            const fftw_complex& mirrored = column[j == 0 ? 0 : period_y_ - j];
            to[period_x_ - k][0] = mirrored[0];
            to[period_x_ - k][1] = -mirrored[1];
        }
    }
}

template <std::size_t n_in>
void MirroredConvolution::rows_forward(const GridConvolution::ConstantFields<n_in>& in) const {
    for_each_piece(n_y_, [&](int first, int thread) {
        fftw_complex* const rows = workspaces_[thread].row.get();
        for (int j = first; j < std::min(first + lines, n_y_); ++j) {
            fftw_complex* const to = rows + static_cast<std::size_t>(j - first) * period_x_;
            const std::size_t start = static_cast<std::size_t>(j) * n_x_;
            for (int i = 0; i < n_x_; ++i) {
                to[i][0] = in[0][start + i];
                to[i][1] = n_in == 2 ? in[n_in - 1][start + i] : 0;
            }
        }
        fftw_execute_dft(by_rows_.forward.get(), rows, row(first));
    });
}

template <std::size_t n_out>
void MirroredConvolution::rows_backward(const GridConvolution::Fields<n_out>& out) const {
    for_each_piece(n_y_, [&](int first, int thread) {
        fftw_complex* const rows = workspaces_[thread].row_back.get();
        fftw_execute_dft(by_rows_.backward.get(), row(first), rows);
        for (int j = first; j < std::min(first + lines, n_y_); ++j) {
            const fftw_complex* const from = rows + static_cast<std::size_t>(j - first) * period_x_;
            const std::size_t start = static_cast<std::size_t>(j) * n_x_;
            for (int i = 0; i < n_x_; ++i) {
                out[0][start + i] = from[i][0];
                if (n_out == 2) out[n_out - 1][start + i] = j == 0 ? 0 : from[i][1];
            }
        }
    });
}

/// Of `n` columns, the first one `first`; `from` and `to` may be the same.
template <std::size_t n_out, std::size_t n_in>
void MirroredConvolution::multiply_columns(const GridConvolution::Kernels<n_out, n_in>& kernels,
                                           int first, int n, const fftw_complex* from,
                                           fftw_complex* to) const {
    for (int i = 0; i < n; ++i, from += period_y_, to += period_y_) {
        const double* symbols[n_out][n_in];
        for (std::size_t a = 0; a < n_out; ++a)
            for (std::size_t b = 0; b < n_in; ++b)
                symbols[a][b] = kernels[a][b]->data() + static_cast<std::size_t>(first + i) * n_ky_;
        for (int k = 0; k < n_ky_; ++k) {
            const int mirrored = k == 0 ? 0 : period_y_ - k;
            const Pair product =
                multiply<n_out, n_in>(symbols, k, {load(from[k]), load(from[mirrored])});
            store(to[mirrored], product.there);
            store(to[k], product.here);
        }
    }
}

const MirroredConvolution::Plans& MirroredConvolution::columns_plans(int n) const {
    return n == lines ? by_columns_ : by_last_columns_;
}

template <std::size_t n_out, std::size_t n_in, Phase phase>
void MirroredConvolution::apply(const GridConvolution::Kernels<n_out, n_in>& kernels,
                                const GridConvolution::ConstantFields<n_in>& in,
                                const GridConvolution::Fields<n_out>& out) const {
    rows_forward<n_in>(in);
    for_each_piece(n_kx_, [&](int first, int thread) {
        const Workspace& work = workspaces_[thread];
        fftw_complex* const spectra = work.column_spectrum.get();
        const int n = std::min(lines, n_kx_ - first);
        const Plans& plans = columns_plans(n);
        gather_columns(first, n, work.column.get());
        fftw_execute_dft(plans.forward.get(), work.column.get(), spectra);
        multiply_columns<n_out, n_in>(kernels, first, n, spectra, spectra);
        fftw_execute_dft(plans.backward.get(), spectra, work.column_back.get());
        scatter_columns(work.column_back.get(), first, n);
    });
    rows_backward<n_out>(out);
}

template <std::size_t n_out, std::size_t n_in>
void MirroredConvolution::apply_each(std::span<const GridConvolution::Kernels<n_out, n_in>> kernels,
                                     const GridConvolution::ConstantFields<n_in>& in,
                                     std::span<const GridConvolution::Fields<n_out>> out) const {
    if (!whole_spectrum_) whole_spectrum_ = zeros(static_cast<std::size_t>(n_kx_) * period_y_);
    auto whole = [&](int first) {
        return whole_spectrum_.get() + static_cast<std::size_t>(first) * period_y_;
    };
    rows_forward<n_in>(in);
    for_each_piece(n_kx_, [&](int first, int thread) {
        const int n = std::min(lines, n_kx_ - first);
        fftw_complex* const columns = workspaces_[thread].column.get();
        gather_columns(first, n, columns);
        fftw_execute_dft(columns_plans(n).forward.get(), columns, whole(first));
    });
    for (std::size_t m = 0; m < kernels.size(); ++m) {
        for_each_piece(n_kx_, [&](int first, int thread) {
            const Workspace& work = workspaces_[thread];
            fftw_complex* const spectra = work.column_spectrum.get();
            const int n = std::min(lines, n_kx_ - first);
            multiply_columns<n_out, n_in>(kernels[m], first, n, whole(first), spectra);
            fftw_execute_dft(columns_plans(n).backward.get(), spectra, work.column_back.get());
            scatter_columns(work.column_back.get(), first, n);
        });
        rows_backward<n_out>(out[m]);
    }
}

using Mirrored = MirroredConvolution;
template void Mirrored::apply<1, 1>(const GridConvolution::Kernels<1, 1>&,
                                    const GridConvolution::ConstantFields<1>&,
                                    const GridConvolution::Fields<1>&) const;
template void Mirrored::apply<2, 2>(const GridConvolution::Kernels<2, 2>&,
                                    const GridConvolution::ConstantFields<2>&,
                                    const GridConvolution::Fields<2>&) const;
template void Mirrored::apply<2, 1, Phase::forward>(const GridConvolution::Kernels<2, 1>&,
                                                    const GridConvolution::ConstantFields<1>&,
                                                    const GridConvolution::Fields<2>&) const;
template void Mirrored::apply<1, 2, Phase::backward>(const GridConvolution::Kernels<1, 2>&,
                                                     const GridConvolution::ConstantFields<2>&,
                                                     const GridConvolution::Fields<1>&) const;
template void Mirrored::apply_each<1, 1>(std::span<const GridConvolution::Kernels<1, 1>>,
                                         const GridConvolution::ConstantFields<1>&,
                                         std::span<const GridConvolution::Fields<1>>) const;
template void Mirrored::apply_each<2, 2>(std::span<const GridConvolution::Kernels<2, 2>>,
                                         const GridConvolution::ConstantFields<2>&,
                                         std::span<const GridConvolution::Fields<2>>) const;

}  // namespace tricontact::bem
