#include "bem/normal_level.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Coarser grids for NormalNewton, by Galerkin projection: pressures uniform on squares of four
// cells ((1, 1) per direction) and the means of displacements over them ((1/2, 1/2)) are together
// the weights w = (1/2, 1, 1/2), whose transform is 2 cos^2(theta/2). Reading every second cell
// folds the wave numbers m and m + P/2 onto each other. The coarse symbol is a sum of four
// products: a quarter of the size, without a transform.

namespace tricontact::bem {

namespace {

using Symbol = GridConvolution::Symbol;

constexpr double coarsest = 64. * 64.;  // cells
constexpr double least_mean = 1e-6;     // displaced by a mean, over what the longest wave displaces

/// The wave numbers of another period next to those of `period`, signs as FFTW wraps them.
std::vector<int> nearest(int period, int other_period) {
    const double ratio = static_cast<double>(other_period) / period;
    std::vector<int> at;
    for (int k = 0; k < period; ++k) {
        const int m = static_cast<int>(std::lround((2 * k <= period ? k : k - period) * ratio));
        at.push_back(m < 0 ? m + other_period : m);
    }
    return at;
}

// The preconditioner's wave numbers are those of the bare grid, the symbol's those of the padded
// one: the nearest is taken. It need not be exact, but positive, also where truncation makes K
// negative.
/// 1/|K|, sampled where the wave numbers of a grid without padding are.
Symbol inverse_on(const GridConvolution& bare, const GridConvolution& padded,
                  const Symbol& symbol) {
    const int period_x = bare.period_x(), period_y = bare.period_y();
    const std::vector<int> x = nearest(period_x, padded.period_x()),
                           y = nearest(period_y, padded.period_y());
    auto size = [&](int i, int j) {
        return std::abs(symbol[static_cast<std::size_t>(x[i]) * padded.period_y() + y[j]]);
    };
    // A mean may displace nothing but for rounding: then any positive number will do.
    const double mean = std::max(size(0, 0), least_mean * std::max(size(1, 0), size(0, 1)));
    Symbol inverse = bare.zero_symbol();
#pragma omp parallel for num_threads(bare.n_threads()) if (bare.n_threads() > 1) schedule(static)
    for (int i = 0; i <= period_x / 2; ++i)
        for (int j = 0; j < period_y; ++j)
            inverse[static_cast<std::size_t>(i) * period_y + j] =
                1 / (i + j == 0 ? mean : size(i, j));
    return inverse;
}

/// cos^2(theta/2) of all wave numbers.
std::vector<double> smoothing(int period) {
    std::vector<double> factors;
    for (int k = 0; k < period; ++k) {
        const double c = std::cos(std::numbers::pi * k / period);
        factors.push_back(c * c);
    }
    return factors;
}

/// See NormalLevel. Symbols are over the number of cells in a period.
Symbol projected(const Symbol& symbol, const GridConvolution& coarse) {
    const int period_x = coarse.period_x(), period_y = coarse.period_y();
    const int fine_x = 2 * period_x, fine_y = 2 * period_y;
    const std::vector<double> x = smoothing(fine_x), y = smoothing(fine_y);
    auto product = [&](int i, int j) {
        const bool is_stored = 2 * i <= fine_x;  // else K(m) = K(-m)
        const int k = is_stored ? i : fine_x - i, l = is_stored || j == 0 ? j : fine_y - j;
        return x[i] * y[j] * symbol[static_cast<std::size_t>(k) * fine_y + l];
    };
    Symbol result = coarse.zero_symbol();
#pragma omp parallel for num_threads(coarse.n_threads()) if (coarse.n_threads() > 1) \
    schedule(static)
    for (int i = 0; i <= period_x / 2; ++i)
        for (int j = 0; j < period_y; ++j)
            result[static_cast<std::size_t>(i) * period_y + j] =
                4 * (product(i, j) + product(i, j + period_y) + product(i + period_x, j) +
                     product(i + period_x, j + period_y));
    return result;
}

}  // namespace

NormalLevel::NormalLevel(const GridConvolution& convolution, const Symbol& symbol, double cell_area)
    : convolution_(convolution), symbol_(symbol), cell_area_(cell_area) {
    make_inverse();
}

NormalLevel::NormalLevel(std::unique_ptr<const Projection> projection, double cell_area)
    : projection_(std::move(projection)),
      convolution_(projection_->convolution),
      symbol_(projection_->symbol),
      cell_area_(cell_area) {
    make_inverse();
}

void NormalLevel::make_inverse() {
    if (convolution_.period_x() > n_x() || convolution_.period_y() > n_y())
        bare_.emplace(n_x(), n_y(), GridConvolution::row_period(n_x()),
                      good_complex_fft_size(n_y()), n_threads());
    inverse_ = inverse_on(bare_ ? *bare_ : convolution_, convolution_, symbol_);
}

std::unique_ptr<const contact::NormalGrid> NormalLevel::coarser() const {
    const int period_x = convolution_.period_x(), period_y = convolution_.period_y();
    if (static_cast<double>(n_x()) * n_y() <= coarsest || period_x % 4 != 0 || period_y % 4 != 0)
        return nullptr;
    GridConvolution half((n_x() + 1) / 2, (n_y() + 1) / 2, period_x / 2, period_y / 2, n_threads());
    Symbol symbol = projected(symbol_, half);
    return std::unique_ptr<const NormalLevel>(new NormalLevel(
        std::make_unique<const Projection>(Projection{std::move(half), std::move(symbol)}),
        4 * cell_area_));
}

}  // namespace tricontact::bem
