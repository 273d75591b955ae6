#include "bem/fourier_coefficients.h"

#include <omp.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

namespace tricontact::bem {

namespace {

/// What one thread transforms of a kernel.
struct KernelPiece {
    FftwReal row;
    FftwComplex row_spectrum, columns, columns_spectrum;
};
constexpr int kernel_columns = 8;
/// From here on kernels are transformed by pieces, which threads share; smaller ones at once.
constexpr double kernel_worth_pieces = 4e5;

KernelPiece kernel_piece(int period_x, int period_y) {
    const auto n = static_cast<std::size_t>(kernel_columns) * period_y;
    return {contact::fftw_zeros<FftwReal>(period_x),
            contact::fftw_zeros<FftwComplex>(period_x / 2 + 1), contact::fftw_zeros<FftwComplex>(n),
            contact::fftw_zeros<FftwComplex>(n)};
}

/// Of arrays like these. A grid has a dozen symbols of one size, and the next grid often the same:
/// FFTW takes as long to find a plan again as to transform a small kernel.
fftw_plan kernel_plan(int period_x, int period_y, const FftwReal& from, const FftwComplex& to) {
    constexpr std::size_t most_plans = 16;
    thread_local std::map<std::pair<int, int>, FftwPlan> plans;
    if (plans.size() >= most_plans && !plans.contains({period_x, period_y})) plans.clear();
    FftwPlan& plan = plans[{period_x, period_y}];
    if (!plan)
        plan.reset(fftw_plan_dft_r2c_2d(period_y, period_x, from.get(), to.get(), FFTW_ESTIMATE));
    return plan.get();
}

}  // namespace

int wrapped(int i, int period) {
    return i <= period / 2 ? i : i - period;
}

GridConvolution::Symbol fourier_coefficients(int period_x, int period_y,
                                             const std::function<double(int, int)>& coefficient,
                                             GridConvolution::Parity parity, int n_threads) {
    const int n_kx = period_x / 2 + 1;
    auto value = [&](int i, int j) {
        const int k = wrapped(i, period_x), l = wrapped(j, period_y);
        const int other_k = 2 * i == period_x ? -k : k, other_l = 2 * j == period_y ? -l : l;
        if (other_k == k && other_l == l) return coefficient(k, l);
        return (coefficient(k, l) + coefficient(other_k, l) + coefficient(k, other_l) +
                coefficient(other_k, other_l)) /
               4;
    };
    const auto spectrum =
        contact::fftw_memory<FftwComplex>(static_cast<std::size_t>(n_kx) * period_y);
    std::vector<KernelPiece> pieces;
    for (int k = 0; k < n_threads; ++k) pieces.push_back(kernel_piece(period_x, period_y));
    const KernelPiece& first = pieces.front();
    FftwPlan row, columns;
    const bool by_pieces = static_cast<double>(period_x) * period_y >= kernel_worth_pieces;
    if (by_pieces) {
        row.reset(fftw_plan_dft_r2c_1d(period_x, first.row.get(), first.row_spectrum.get(),
                                       FFTW_ESTIMATE));
        columns.reset(fftw_plan_many_dft(1, &period_y, kernel_columns, first.columns.get(), nullptr,
                                         1, period_y, first.columns_spectrum.get(), nullptr, 1,
                                         period_y, FFTW_FORWARD, FFTW_ESTIMATE));
    } else {
        const auto kernel =
            contact::fftw_memory<FftwReal>(static_cast<std::size_t>(period_x) * period_y);
        for (int j = 0; j < period_y; ++j)
            for (int i = 0; i < period_x; ++i)
                kernel[static_cast<std::size_t>(j) * period_x + i] = value(i, j);
        fftw_execute_dft_r2c(kernel_plan(period_x, period_y, kernel, spectrum), kernel.get(),
                             spectrum.get());
    }
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int j = 0; j < (by_pieces ? period_y : 0); ++j) {
        const KernelPiece& piece = pieces[omp_get_thread_num()];
        for (int i = 0; i < period_x; ++i) piece.row[i] = value(i, j);
        fftw_execute_dft_r2c(row.get(), piece.row.get(), piece.row_spectrum.get());
        std::memcpy(spectrum.get() + static_cast<std::size_t>(j) * n_kx, piece.row_spectrum.get(),
                    n_kx * sizeof(fftw_complex));
    }

    const double scale = 1.0 / (static_cast<double>(period_x) * period_y);
    const int part = parity == GridConvolution::Parity::odd ? 1 : 0;
    GridConvolution::Symbol result;
    // With room for what a GridConvolution pads it with.
    contact::reserve_large(result, static_cast<std::size_t>(period_y) * (n_kx + kernel_columns),
                           n_threads);
    result.resize(static_cast<std::size_t>(period_y) * n_kx);
#pragma omp parallel for num_threads(n_threads) if (n_threads > 1) schedule(static)
    for (int i = 0; i < n_kx; i += kernel_columns) {
        const KernelPiece& piece = pieces[omp_get_thread_num()];
        const int n = std::min(kernel_columns, n_kx - i);
        for (int j = 0; j < period_y; ++j)
            for (int k = 0; k < n; ++k)
                std::memcpy(piece.columns.get() + static_cast<std::size_t>(k) * period_y + j,
                            spectrum.get() + static_cast<std::size_t>(j) * n_kx + i + k,
                            sizeof(fftw_complex));
        if (by_pieces)
            fftw_execute_dft(columns.get(), piece.columns.get(), piece.columns_spectrum.get());
        const FftwComplex& transformed = by_pieces ? piece.columns_spectrum : piece.columns;
        for (int k = 0; k < n * period_y; ++k)
            result[static_cast<std::size_t>(i) * period_y + k] = scale * transformed[k][part];
    }
    return result;
}

}  // namespace tricontact::bem
