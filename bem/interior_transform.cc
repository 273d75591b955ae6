#include "bem/interior_transform.h"

#include <algorithm>
#include <cstring>

namespace tricontact::bem {

namespace {

// Of displacements and stresses: how many of their indices are x and y.
constexpr std::array<std::array<int, 2>, 3> of_displacement = {{{1, 0}, {0, 1}, {0, 0}}};
constexpr std::array<std::array<int, 2>, 6> of_stress = {
    {{2, 0}, {0, 2}, {0, 0}, {1, 1}, {0, 1}, {1, 0}}};

}  // namespace

InteriorTransform::InteriorTransform(int n_x, int n_y,
                                     const std::array<std::vector<double>, 3>& tractions)
    : n_x_(n_x),
      n_y_(n_y),
      period_x_(good_fft_size(2 * n_x - 1)),
      period_y_(good_fft_size(2 * n_y - 1)) {
    const auto padded = contact::fftw_zeros<FftwReal>(n_real());
    const auto spectrum = contact::fftw_zeros<FftwComplex>(n_complex());
    forward_.reset(
        fftw_plan_dft_r2c_2d(period_y_, period_x_, padded.get(), spectrum.get(), FFTW_ESTIMATE));
    backward_.reset(
        fftw_plan_dft_c2r_2d(period_y_, period_x_, spectrum.get(), padded.get(), FFTW_ESTIMATE));
    for (int d = 0; d < 3; ++d) {
        const auto& traction = tractions[d];
        if (std::all_of(traction.begin(), traction.end(), [](double t) { return t == 0; }))
            continue;
        std::fill_n(padded.get(), n_real(), 0.0);
        for (int j = 0; j < n_y; ++j)
            std::copy_n(traction.data() + static_cast<std::size_t>(j) * n_x, n_x,
                        padded.get() + static_cast<std::size_t>(j) * period_x_);
        tractions_[d] = contact::fftw_zeros<FftwComplex>(n_complex());
        fftw_execute_dft_r2c(forward_.get(), padded.get(), tractions_[d].get());
    }
}

InteriorTransform::Level::Level(const InteriorTransform& transform, const Influence& influence)
    : transform_(transform),
      kernel_(contact::fftw_zeros<FftwReal>(transform.n_real())),
      spectrum_(contact::fftw_zeros<FftwComplex>(transform.n_complex())),
      sum_(contact::fftw_zeros<FftwComplex>(transform.n_complex())) {
    for (int j = 0; j < transform.n_y_; ++j)
        for (int i = 0; i < transform.n_x_; ++i) quadrant_.push_back(influence(i, j));
    out_.resize(quadrant_.size());
}

void InteriorTransform::Level::fill_kernel(const Coefficient& coefficient, int direction,
                                           double sign_x, double sign_y) {
    const auto& of = transform_;
    std::fill_n(kernel_.get(), of.n_real(), 0.0);
    auto row = [&](int j) { return kernel_.get() + static_cast<std::size_t>(j) * of.period_x_; };
    auto at = quadrant_.begin();
    for (int j = 0; j < of.n_y_; ++j) {
        double *here = row(j), *opposite = row(j > 0 ? of.period_y_ - j : 0);
        for (int i = 0; i < of.n_x_; ++i) {
            const double value = coefficient(*at++, direction);
            const int mirrored = i > 0 ? of.period_x_ - i : 0;
            opposite[mirrored] = (i > 0 ? sign_x : 1) * (j > 0 ? sign_y : 1) * value;
            opposite[i] = (j > 0 ? sign_y : 1) * value;
            here[mirrored] = (i > 0 ? sign_x : 1) * value;
            here[i] = value;
        }
    }
}

std::span<const double> InteriorTransform::Level::field(const Coefficient& coefficient, int n_x,
                                                        int n_y) {
    const auto& of = transform_;
    std::memset(sum_.get(), 0, of.n_complex() * sizeof(fftw_complex));
    for (int d = 0; d < 3; ++d) {
        const fftw_complex* traction = of.tractions_[d].get();
        if (!traction) continue;
        fill_kernel(coefficient, d, (n_x + (d == 0)) % 2 == 0 ? 1 : -1,
                    (n_y + (d == 1)) % 2 == 0 ? 1 : -1);
        fftw_execute_dft_r2c(of.forward_.get(), kernel_.get(), spectrum_.get());
        for (std::size_t k = 0; k < of.n_complex(); ++k) {
            const auto &a = spectrum_[k], &b = traction[k];
            sum_[k][0] += a[0] * b[0] - a[1] * b[1];
            sum_[k][1] += a[0] * b[1] + a[1] * b[0];
        }
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
