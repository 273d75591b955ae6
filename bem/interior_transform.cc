#include "bem/interior_transform.h"

#include <algorithm>
#include <cstring>

// There are 27 kernels in each depth: 9 fields, 3 loads. A kernel's parity under (x, y) -> (-x, -y)
// makes its spectrum real or imaginary: the response to a pressing force and that to a force along
// x have opposite parities in every field. Both kernels are added into one real field, whose
// spectrum separates them into real and imaginary part (`add_product`). Two transforms per field
// instead of three, and one back.

namespace tricontact::bem {

namespace {

// Of displacements and stresses: how many of their indices are x and y.
constexpr std::array<std::array<int, 2>, 3> of_displacement = {{{1, 0}, {0, 1}, {0, 0}}};
constexpr std::array<std::array<int, 2>, 6> of_stress = {
    {{2, 0}, {0, 2}, {0, 0}, {1, 1}, {0, 1}, {1, 0}}};

/// Indices from `first` to `last`.
struct Range {
    int first, last;

    void include(int i) {
        first = std::min(first, i);
        last = std::max(last, i);
    }
    /// From one of them to the farthest of 0 ... n - 1.
    int reach(int n) const { return std::max({0, last, n - 1 - first}); }
};

/// At (y, x), of a body for which x and y are alike.
theory::InteriorResponse with_axes_swapped(const theory::InteriorResponse& r) {
    constexpr std::array<std::size_t, 3> direction{1, 0, 2};
    constexpr std::array<std::size_t, 6> component{1, 0, 2, 3, 5, 4};  // XX YY ZZ XY YZ XZ
    theory::InteriorResponse swapped;
    for (std::size_t load = 0; load < 3; ++load) {
        for (std::size_t c = 0; c < 3; ++c)
            swapped.displacement[c][load] = r.displacement[direction[c]][direction[load]];
        for (std::size_t c = 0; c < 6; ++c)
            swapped.stress[c][load] = r.stress[component[c]][direction[load]];
    }
    return swapped;
}

bool is_free(const std::vector<double>& traction) {
    return std::ranges::all_of(traction, [](double t) { return t == 0; });
}

}  // namespace

InteriorTransform::InteriorTransform(int n_x, int n_y,
                                     const std::array<std::vector<double>, 3>& tractions)
    : n_x_(n_x), n_y_(n_y) {
    Range columns{n_x, -1}, rows{n_y, -1};
    for (const auto& traction : tractions)
        for (std::size_t k = 0; k < traction.size(); ++k)
            if (traction[k] != 0) {
                columns.include(static_cast<int>(k) % n_x);
                rows.include(static_cast<int>(k) / n_x);
            }
    if (columns.last >= 0) reach_x_ = columns.reach(n_x), reach_y_ = rows.reach(n_y);
    period_x_ = good_fft_size(std::max(n_x, 2 * reach_x_ + 1));
    period_y_ = good_fft_size(std::max(n_y, 2 * reach_y_ + 1));

    const auto padded = contact::fftw_zeros<FftwReal>(n_real());
    const auto spectrum = contact::fftw_zeros<FftwComplex>(n_complex());
    forward_.reset(
        fftw_plan_dft_r2c_2d(period_y_, period_x_, padded.get(), spectrum.get(), FFTW_ESTIMATE));
    backward_.reset(
        fftw_plan_dft_c2r_2d(period_y_, period_x_, spectrum.get(), padded.get(), FFTW_ESTIMATE));
    for (int d = 0; d < 3; ++d) {
        const auto& traction = tractions[d];
        if (is_free(traction)) continue;
        std::fill_n(padded.get(), n_real(), 0.0);
        for (int j = 0; j < n_y; ++j)
            std::copy_n(traction.data() + static_cast<std::size_t>(j) * n_x, n_x,
                        padded.get() + static_cast<std::size_t>(j) * period_x_);
        tractions_[d] = contact::fftw_zeros<FftwComplex>(n_complex());
        fftw_execute_dft_r2c(forward_.get(), padded.get(), tractions_[d].get());
    }
}

InteriorTransform::Level::Level(const InteriorTransform& transform, const Influence& influence,
                                bool square)
    : transform_(transform),
      kernel_(contact::fftw_zeros<FftwReal>(transform.n_real())),
      spectrum_(contact::fftw_zeros<FftwComplex>(transform.n_complex())),
      sum_(contact::fftw_zeros<FftwComplex>(transform.n_complex())) {
    const int width = transform.reach_x_ + 1;
    quadrant_.reserve(static_cast<std::size_t>(width) * (transform.reach_y_ + 1));
    for (int j = 0; j <= transform.reach_y_; ++j)
        for (int i = 0; i < width; ++i) {
            const bool is_known = square && i < j && j < width;
            quadrant_.push_back(is_known ? with_axes_swapped(quadrant_[i * width + j])
                                         : influence(i, j));
        }
    out_.resize(static_cast<std::size_t>(transform.n_x_) * transform.n_y_);
}

/// Odd in x or y: of the other sign on the other side, so zero on the axis.
template <class Coefficient>
void InteriorTransform::Level::add_to_kernel(const Coefficient& coefficient, int direction,
                                             bool odd_x, bool odd_y) {
    const auto& of = transform_;
    const double sign_x = odd_x ? -1 : 1, sign_y = odd_y ? -1 : 1;
    const auto row = [&](int j) {
        return kernel_.get() + static_cast<std::size_t>(j) * of.period_x_;
    };
    auto at = quadrant_.begin();
    for (int j = 0; j <= of.reach_y_; ++j) {
        double *here = row(j), *opposite = row(j > 0 ? of.period_y_ - j : 0);
        for (int i = 0; i <= of.reach_x_; ++i, ++at) {
            if ((i == 0 && odd_x) || (j == 0 && odd_y)) continue;
            const double value = coefficient(*at, direction);
            const int mirrored = of.period_x_ - i;
            here[i] += value;
            if (i > 0) here[mirrored] += sign_x * value;
            if (j > 0) opposite[i] += sign_y * value;
            if (i > 0 && j > 0) opposite[mirrored] += sign_x * sign_y * value;
        }
    }
}

/// Of a kernel's even part, whose spectrum is real, and its odd one, whose is imaginary, each with
/// a traction of its own, or none.
void InteriorTransform::Level::add_product(const fftw_complex* even, const fftw_complex* odd) {
    const std::size_t n = transform_.n_complex();
    if (even)
        for (std::size_t k = 0; k < n; ++k) {
            sum_[k][0] += spectrum_[k][0] * even[k][0];
            sum_[k][1] += spectrum_[k][0] * even[k][1];
        }
    if (odd)
        for (std::size_t k = 0; k < n; ++k) {
            sum_[k][0] -= spectrum_[k][1] * odd[k][1];
            sum_[k][1] += spectrum_[k][1] * odd[k][0];
        }
}

template <class Coefficient>
std::span<const double> InteriorTransform::Level::field(const Coefficient& coefficient, int n_x,
                                                        int n_y) {
    const auto& of = transform_;
    std::memset(sum_.get(), 0, of.n_complex() * sizeof(fftw_complex));
    // What a force along x or y makes is odd where that of a pressing one is even: both in one
    // transform.
    constexpr std::array<std::array<int, 2>, 2> pairs{{{0, 2}, {1, -1}}};
    for (const auto& pair : pairs) {
        std::array<const fftw_complex*, 2> of_parity{};
        std::fill_n(kernel_.get(), of.n_real(), 0.0);
        for (const int d : pair) {
            if (d < 0 || !of.tractions_[d]) continue;
            const bool odd_x = (n_x + (d == 0)) % 2 == 1, odd_y = (n_y + (d == 1)) % 2 == 1;
            add_to_kernel(coefficient, d, odd_x, odd_y);
            of_parity[odd_x != odd_y] = of.tractions_[d].get();
        }
        if (!of_parity[0] && !of_parity[1]) continue;
        fftw_execute_dft_r2c(of.forward_.get(), kernel_.get(), spectrum_.get());
        add_product(of_parity[0], of_parity[1]);
    }
    fftw_execute_dft_c2r(of.backward_.get(), sum_.get(), kernel_.get());
    const double scale = 1.0 / static_cast<double>(of.n_real());
    for (int j = 0; j < of.n_y_; ++j)
        for (int i = 0; i < of.n_x_; ++i)
            out_[static_cast<std::size_t>(j) * of.n_x_ + i] =
                scale * kernel_[static_cast<std::size_t>(j) * of.period_x_ + i];
    return out_;
}

std::span<const double> InteriorTransform::Level::displacement(int c) {
    return field([c](const theory::InteriorResponse& r, int d) { return r.displacement[c][d]; },
                 of_displacement[c][0], of_displacement[c][1]);
}

std::span<const double> InteriorTransform::Level::stress(int c) {
    return field([c](const theory::InteriorResponse& r, int d) { return r.stress[c][d]; },
                 of_stress[c][0], of_stress[c][1]);
}

}  // namespace tricontact::bem
