#include "bem/grid_convolution.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bem/fourier_coefficients.h"
#include "contact/compliances/blocks.h"

namespace tricontact::bem {

namespace {

int whole(int n, int piece) {
    return (n + piece - 1) / piece * piece;
}

bool is_good(int n) {
    for (const int prime : {2, 3, 5, 7})
        while (n % prime == 0) n /= prime;
    return n == 1;
}

}  // namespace

int good_fft_size(int n) {
    n += n % 2;
    while (!is_good(n)) n += 2;
    return n;
}

int good_complex_fft_size(int n) {
    n = good_fft_size(n);
    while (n % 9 == 0) n = good_fft_size(n + 1);
    return n;
}

GridConvolution::GridConvolution(int n_x, int n_y, int period_x, int period_y, int n_threads)
    : n_x_(n_x),
      n_y_(n_y),
      period_x_(period_x),
      period_y_(period_y),
      n_threads_(n_threads),
      n_rows_(whole(n_y, piece)),
      pitch_(whole(period_x / 2 + 1, piece)) {
    for (int k = 0; k < n_threads; ++k)
        rows_.push_back(
            {contact::fftw_zeros<FftwReal>(static_cast<std::size_t>(piece) * period_x),
             contact::fftw_zeros<FftwComplex>(static_cast<std::size_t>(piece) * pitch_)});
    spectrum_[0] = make_spectrum();
    double* rows = rows_.front().values.get();
    fftw_complex* spectrum = rows_.front().spectrum.get();
    row_forward_.reset(fftw_plan_many_dft_r2c(1, &period_x_, piece, rows, nullptr, 1, period_x_,
                                              spectrum, nullptr, 1, pitch_, FFTW_ESTIMATE));
    row_backward_.reset(fftw_plan_many_dft_c2r(1, &period_x_, piece, spectrum, nullptr, 1, pitch_,
                                               rows, nullptr, 1, period_x_, FFTW_ESTIMATE));
    for (int k = 0; k < 2 * n_threads; ++k) {
        const std::size_t n = static_cast<std::size_t>(piece) * period_y;
        columns_.push_back(
            {contact::fftw_zeros<FftwComplex>(n), contact::fftw_zeros<FftwComplex>(n)});
    }
    // Out of place FFTW's estimated plans take two thirds of the time.
    const Columns& columns = columns_.front();
    auto column_plan = [&](int sign) {
        return FftwPlan(fftw_plan_many_dft(1, &period_y_, piece, columns.values.get(), nullptr, 1,
                                           period_y_, columns.spectrum.get(), nullptr, 1, period_y_,
                                           sign, FFTW_ESTIMATE));
    };
    column_forward_ = column_plan(FFTW_FORWARD);
    column_backward_ = column_plan(FFTW_BACKWARD);
}

FftwComplex GridConvolution::make_spectrum() const {
    return contact::fftw_memory<FftwComplex>(static_cast<std::size_t>(n_rows_) * pitch_);
}

template <typename Body>
void GridConvolution::for_each_piece(int n, Body body) const {
    if (n_threads_ == 1) {
        for (int first = 0; first < n; first += piece) body(first, 0);
        return;
    }
#pragma omp parallel for num_threads(n_threads_) schedule(static)
    for (int first = 0; first < n; first += piece) body(first, omp_get_thread_num());
}

void GridConvolution::rows_forward(std::span<const double> in, fftw_complex* spectrum) const {
    for_each_piece(n_rows_, [&](int first, int thread) {
        const auto& [values, transformed] = rows_[thread];
        for (int j = 0; j < piece; ++j) {
            double* const row = values.get() + static_cast<std::size_t>(j) * period_x_;
            const int n = first + j < n_y_ ? n_x_ : 0;
            if (n > 0) std::copy_n(in.data() + static_cast<std::size_t>(first + j) * n_x_, n, row);
            std::fill(row + n, row + period_x_, 0.0);
        }
        fftw_execute_dft_r2c(row_forward_.get(), values.get(), transformed.get());
        for (int k = 0; k < pitch_; k += piece)
            for (int j = 0; j < piece; ++j)
                std::memcpy(tile(spectrum, first + j, k),
                            transformed.get() + static_cast<std::size_t>(j) * pitch_ + k,
                            piece * sizeof(fftw_complex));
    });
}

void GridConvolution::rows_backward(fftw_complex* spectrum, std::span<double> out) const {
    for_each_piece(n_rows_, [&](int first, int thread) {
        const auto& [values, transformed] = rows_[thread];
        for (int k = 0; k < pitch_; k += piece)
            for (int j = 0; j < piece; ++j)
                std::memcpy(transformed.get() + static_cast<std::size_t>(j) * pitch_ + k,
                            tile(spectrum, first + j, k), piece * sizeof(fftw_complex));
        fftw_execute_dft_c2r(row_backward_.get(), transformed.get(), values.get());
        for (int j = first; j < std::min(first + piece, n_y_); ++j)
            std::copy_n(values.get() + static_cast<std::size_t>(j - first) * period_x_, n_x_,
                        out.data() + static_cast<std::size_t>(j) * n_x_);
    });
}

const GridConvolution::Columns& GridConvolution::columns_of(int thread, int component) const {
    return columns_[2 * thread + component];
}

void GridConvolution::columns_forward(const fftw_complex* tile, const Columns& to) const {
    fftw_complex* const columns = to.values.get();
    for (int j = 0; j < n_y_; ++j) {
        const fftw_complex* row = tile + static_cast<std::size_t>(j) * piece;
        for (int i = 0; i < piece; ++i) {
            fftw_complex& cell = columns[static_cast<std::size_t>(i) * period_y_ + j];
            cell[0] = row[i][0];
            cell[1] = row[i][1];
        }
    }
    for (int i = 0; i < piece; ++i)
        std::memset(columns + static_cast<std::size_t>(i) * period_y_ + n_y_, 0,
                    (period_y_ - n_y_) * sizeof(fftw_complex));
    fftw_execute_dft(column_forward_.get(), columns, to.spectrum.get());
}

void GridConvolution::columns_backward(const Columns& from_spectrum, fftw_complex* tile) const {
    const fftw_complex* const columns = from_spectrum.values.get();
    fftw_execute_dft(column_backward_.get(), from_spectrum.spectrum.get(),
                     from_spectrum.values.get());
    for (int j = 0; j < n_y_; ++j) {
        fftw_complex* row = tile + static_cast<std::size_t>(j) * piece;
        for (int i = 0; i < piece; ++i) {
            const fftw_complex& from = columns[static_cast<std::size_t>(i) * period_y_ + j];
            row[i][0] = from[0];
            row[i][1] = from[1];
        }
    }
}

GridConvolution::Symbol GridConvolution::symbol(const std::function<double(int, int)>& coefficient,
                                                Parity parity) const {
    Symbol result = fourier_coefficients(period_x_, period_y_, coefficient, parity, n_threads_);
    result.resize(static_cast<std::size_t>(period_y_) * pitch_, 0.0);
    return result;
}

GridConvolution::Symbol GridConvolution::symbol_of_coefficients(
    const std::function<double(int, int)>& coefficient) const {
    const double scale = 1.0 / (static_cast<double>(period_x_) * period_y_);
    Symbol result = zero_symbol();
#pragma omp parallel for num_threads(n_threads_) if (n_threads_ > 1) schedule(static)
    for (int i = 0; i <= period_x_ / 2; ++i)
        for (int j = 0; j < period_y_; ++j)
            result[static_cast<std::size_t>(i) * period_y_ + j] =
                scale * coefficient(i, wrapped(j, period_y_));
    return result;
}

template <std::size_t n_out, std::size_t n_in, GridConvolution::Phase phase>
void GridConvolution::apply(const Kernels<n_out, n_in>& kernels, const ConstantFields<n_in>& in,
                            const Fields<n_out>& out) const {
    if (std::max(n_in, n_out) == 2 && !spectrum_[1]) spectrum_[1] = make_spectrum();
    for (std::size_t i = 0; i < n_in; ++i) rows_forward(in[i], spectrum_[i].get());
    for_each_piece(pitch_, [&](int first, int thread) {
        for (std::size_t i = 0; i < n_in; ++i)
            columns_forward(tile(spectrum_[i].get(), 0, first), columns_of(thread, i));
        fftw_complex* const columns[2] = {columns_of(thread, 0).spectrum.get(),
                                          columns_of(thread, 1).spectrum.get()};
        const std::size_t start = static_cast<std::size_t>(first) * period_y_;
        const double* symbols[n_out][n_in];
        for (std::size_t i = 0; i < n_out; ++i)
            for (std::size_t j = 0; j < n_in; ++j) symbols[i][j] = kernels[i][j]->data() + start;
        for (int k = 0; k < piece * period_y_; ++k) {
            double sums[n_out][2];
            for (std::size_t i = 0; i < n_out; ++i)
                for (const int part : {0, 1}) {
                    sums[i][part] = symbols[i][0][k] * columns[0][k][part];
                    if constexpr (n_in == 2)
                        sums[i][part] += symbols[i][1][k] * columns[1][k][part];
                }
            for (std::size_t i = 0; i < n_out; ++i) {
                const auto [re, im] = sums[i];
                fftw_complex& to = columns[i][k];
                to[0] = phase == Phase::none ? re : phase == Phase::forward ? -im : im;
                to[1] = phase == Phase::none ? im : phase == Phase::forward ? re : -re;
            }
        }
        for (std::size_t i = 0; i < n_out; ++i)
            columns_backward(columns_of(thread, i), tile(spectrum_[i].get(), 0, first));
    });
    for (std::size_t i = 0; i < n_out; ++i) rows_backward(spectrum_[i].get(), out[i]);
}

using Convolution = GridConvolution;
template void Convolution::apply<1, 1>(const Kernels<1, 1>&, const ConstantFields<1>&,
                                       const Fields<1>&) const;
template void Convolution::apply<2, 2>(const Kernels<2, 2>&, const ConstantFields<2>&,
                                       const Fields<2>&) const;
template void Convolution::apply<1, 1, Convolution::Phase::forward>(const Kernels<1, 1>&,
                                                                    const ConstantFields<1>&,
                                                                    const Fields<1>&) const;
template void Convolution::apply<2, 2, Convolution::Phase::forward>(const Kernels<2, 2>&,
                                                                    const ConstantFields<2>&,
                                                                    const Fields<2>&) const;
template void Convolution::apply<2, 1>(const Kernels<2, 1>&, const ConstantFields<1>&,
                                       const Fields<2>&) const;
template void Convolution::apply<1, 2>(const Kernels<1, 2>&, const ConstantFields<2>&,
                                       const Fields<1>&) const;
template void Convolution::apply<2, 1, Convolution::Phase::forward>(const Kernels<2, 1>&,
                                                                    const ConstantFields<1>&,
                                                                    const Fields<2>&) const;
template void Convolution::apply<1, 2, Convolution::Phase::backward>(const Kernels<1, 2>&,
                                                                     const ConstantFields<2>&,
                                                                     const Fields<1>&) const;

GridConvolution::Symbol2 inverse(GridConvolution::Symbol2 symbol, int n_threads) {
    contact::Blocks(symbol.xx.size(), n_threads).for_points([&](std::size_t k) {
        double &xx = symbol.xx[k], &xy = symbol.xy[k], &yy = symbol.yy[k];
        if (xx == 0 && yy == 0) return;  // padding of the spectrum's rows
        if (!(xx > 0 && yy > 0 && xx * yy > xy * xy)) {
            xx = std::abs(xx);
            yy = std::abs(yy);
            xy = 0;
        }
        const double determinant = xx * yy - xy * xy, old_xx = xx;
        xx = yy / determinant;
        yy = old_xx / determinant;
        xy = -xy / determinant;
    });
    return symbol;
}

// (B^-1 + D)^-1 = (1 + B D)^-1 B, B positive definite but in the padding of rows, where it is 0.
GridConvolution::Symbol2 inverse_under(const contact::LayerCompliance& layer,
                                       const GridConvolution::Symbol2& bare, int n_threads) {
    GridConvolution::Symbol2 under = bare;
    const double of_layer = layer.xx * layer.yy - layer.xy * layer.xy;
    contact::Blocks(bare.xx.size(), n_threads).for_points([&](std::size_t k) {
        const double xx = bare.xx[k], xy = bare.xy[k], yy = bare.yy[k], of_bare = xx * yy - xy * xy;
        const double determinant =
            1 + xx * layer.xx + 2 * xy * layer.xy + yy * layer.yy + of_bare * of_layer;
        under.xx[k] = (xx + of_bare * layer.yy) / determinant;
        under.xy[k] = (xy - of_bare * layer.xy) / determinant;
        under.yy[k] = (yy + of_bare * layer.xx) / determinant;
    });
    return under;
}

}  // namespace tricontact::bem
