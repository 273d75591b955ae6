#include "bem/interior_transform.h"

#include <algorithm>
#include <cstring>
#include <new>

namespace tricontact::bem {

namespace {

// Of displacements and stresses: how many of their indices are x and y.
constexpr std::array<std::array<int, 2>, 3> of_displacement = {{{1, 0}, {0, 1}, {0, 0}}};
constexpr std::array<std::array<int, 2>, 6> of_stress = {
    {{2, 0}, {0, 2}, {0, 0}, {1, 1}, {0, 1}, {1, 0}}};

template <typename Pointer, typename Allocate>
Pointer checked(Allocate allocate, std::size_t n) {
    Pointer memory(allocate(n));
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

struct InteriorTransform::Parts {
    int n_x, n_y, period_x, period_y;
    std::array<FftwComplex, 3> tractions;  // spectra; null: zero everywhere
    fftw_plan forward, backward;

    std::size_t n_real() const { return static_cast<std::size_t>(period_x) * period_y; }
    std::size_t n_complex() const {
        return (static_cast<std::size_t>(period_x) / 2 + 1) * period_y;
    }
    FftwReal real() const { return checked<FftwReal>(fftw_alloc_real, n_real()); }
    FftwComplex complex() const { return checked<FftwComplex>(fftw_alloc_complex, n_complex()); }
};

InteriorTransform::InteriorTransform(int n_x, int n_y,
                                     const std::array<std::vector<double>, 3>& tractions)
    : parts_(std::make_unique<Parts>()) {
    auto& parts = *parts_;
    parts.n_x = n_x;
    parts.n_y = n_y;
    parts.period_x = good_fft_size(2 * n_x - 1);
    parts.period_y = good_fft_size(2 * n_y - 1);
    const FftwReal padded = parts.real();
    const FftwComplex spectrum = parts.complex();
    parts.forward = fftw_plan_dft_r2c_2d(parts.period_y, parts.period_x, padded.get(),
                                         spectrum.get(), FFTW_ESTIMATE);
    parts.backward = fftw_plan_dft_c2r_2d(parts.period_y, parts.period_x, spectrum.get(),
                                          padded.get(), FFTW_ESTIMATE);
    for (int d = 0; d < 3; ++d) {
        const auto& traction = tractions[d];
        if (std::all_of(traction.begin(), traction.end(), [](double t) { return t == 0; }))
            continue;
        std::fill_n(padded.get(), parts.n_real(), 0.0);
        for (int j = 0; j < n_y; ++j)
            std::copy_n(traction.data() + static_cast<std::size_t>(j) * n_x, n_x,
                        padded.get() + static_cast<std::size_t>(j) * parts.period_x);
        parts.tractions[d] = parts.complex();
        fftw_execute_dft_r2c(parts.forward, padded.get(), parts.tractions[d].get());
    }
}

InteriorTransform::~InteriorTransform() {
    if (!parts_) return;
    fftw_destroy_plan(parts_->forward);
    fftw_destroy_plan(parts_->backward);
}

InteriorTransform::InteriorTransform(InteriorTransform&&) noexcept = default;

InteriorTransform::Level::Level(const InteriorTransform& transform, const Influence& influence)
    : transform_(transform),
      kernel_(transform.parts_->real()),
      spectrum_(transform.parts_->complex()),
      sum_(transform.parts_->complex()) {
    const auto& parts = *transform.parts_;
    for (int j = 0; j < parts.n_y; ++j)
        for (int i = 0; i < parts.n_x; ++i) quadrant_.push_back(influence(i, j));
    out_.resize(quadrant_.size());
}

void InteriorTransform::Level::fill_kernel(const Coefficient& coefficient, int direction,
                                           double sign_x, double sign_y) {
    const auto& parts = *transform_.parts_;
    std::fill_n(kernel_.get(), parts.n_real(), 0.0);
    auto row = [&](int j) { return kernel_.get() + static_cast<std::size_t>(j) * parts.period_x; };
    auto at = quadrant_.begin();
    for (int j = 0; j < parts.n_y; ++j) {
        double *here = row(j), *opposite = row(j > 0 ? parts.period_y - j : 0);
        for (int i = 0; i < parts.n_x; ++i) {
            const double value = coefficient(*at++, direction);
            const int mirrored = i > 0 ? parts.period_x - i : 0;
            opposite[mirrored] = (i > 0 ? sign_x : 1) * (j > 0 ? sign_y : 1) * value;
            opposite[i] = (j > 0 ? sign_y : 1) * value;
            here[mirrored] = (i > 0 ? sign_x : 1) * value;
            here[i] = value;
        }
    }
}

std::span<const double> InteriorTransform::Level::field(const Coefficient& coefficient, int n_x,
                                                        int n_y) {
    const auto& parts = *transform_.parts_;
    std::memset(sum_.get(), 0, parts.n_complex() * sizeof(fftw_complex));
    for (int d = 0; d < 3; ++d) {
        const fftw_complex* traction = parts.tractions[d].get();
        if (!traction) continue;
        fill_kernel(coefficient, d, (n_x + (d == 0)) % 2 == 0 ? 1 : -1,
                    (n_y + (d == 1)) % 2 == 0 ? 1 : -1);
        fftw_execute_dft_r2c(parts.forward, kernel_.get(), spectrum_.get());
        for (std::size_t k = 0; k < parts.n_complex(); ++k) {
            const auto &a = spectrum_[k], &b = traction[k];
            sum_[k][0] += a[0] * b[0] - a[1] * b[1];
            sum_[k][1] += a[0] * b[1] + a[1] * b[0];
        }
    }
    fftw_execute_dft_c2r(parts.backward, sum_.get(), kernel_.get());
    const double scale = 1.0 / static_cast<double>(parts.n_real());
    for (int j = 0; j < parts.n_y; ++j)
        for (int i = 0; i < parts.n_x; ++i)
            out_[static_cast<std::size_t>(j) * parts.n_x + i] =
                scale * kernel_[static_cast<std::size_t>(j) * parts.period_x + i];
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
