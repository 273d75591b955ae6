#include "contact/bodies/roughness.h"

#include <fftw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "contact/error.h"
#include "contact/memory.h"

namespace tricontact::contact {

namespace {

constexpr double quotient_rounding = 1e-9;  // of quotients of wavelengths
constexpr int most_waves = 8192;            // along a side: lattices of 16384 nodes and more

struct Wave {
    int x, y;  // wave vector over 2 pi/L
};

int shortest_wave(const Roughness& r) {
    return static_cast<int>(
        std::floor(r.long_wavelength / r.short_wavelength * (1 + quotient_rounding)));
}

void check(const Roughness& r) {
    const bool ordered = r.short_wavelength > 0 && r.short_wavelength <= r.roll_off &&
                         r.roll_off <= r.long_wavelength && std::isfinite(r.long_wavelength);
    if (!ordered)
        throw InputError(
            "roughness: wavelengths must obey 0 < short_wavelength <= roll_off <= long_wavelength");
    if (!(r.rms_slope > 0) || !std::isfinite(r.rms_slope))
        throw InputError("roughness: the rms slope must be positive and finite");
    if (!(r.hurst >= 0 && r.hurst <= 1)) throw InputError("roughness: hurst must be in [0, 1]");
    if (r.long_wavelength / r.short_wavelength > most_waves)
        throw InputError(fmt::format("roughness: more than {} waves in a period", most_waves));
}

/// Amplitude of `wave` waves in a period, the surface being the sum of 2 amplitude cos(q x +
/// phase), for an rms slope that `scale` sets: the root of C(q), for all waves have the same share
/// of the q plane.
double amplitude(const Roughness& r, double wave) {
    const double roll_off = r.long_wavelength / r.roll_off;
    if (wave < 1 - quotient_rounding ||
        wave * r.short_wavelength > r.long_wavelength * (1 + quotient_rounding))
        return 0;
    return wave <= roll_off ? 1 : std::pow(wave / roll_off, -(1 + r.hurst));
}

double amplitude(const Roughness& r, const Wave& m) {
    return amplitude(r, std::hypot(m.x, m.y));
}

/// All waves up to `n`, one of each pair of opposite ones, ring by ring of max(|m_x|, |m_y|):
/// longer rings come last, so that fewer waves draw the same numbers.
template <typename Visit>
void for_each_wave(int n, Visit visit) {
    for (int ring = 1; ring <= n; ++ring) {
        for (int x = -ring; x <= ring; ++x) visit(Wave{x, ring});
        for (int y = 1; y < ring; ++y) {
            visit(Wave{-ring, y});
            visit(Wave{ring, y});
        }
        visit(Wave{ring, 0});
    }
}

struct Moments {
    double height = 0, slope = 0;  // mean squares, of unscaled amplitudes
};

Moments moments(const Roughness& r) {
    const double unit = 2 * std::numbers::pi / r.long_wavelength;
    Moments sum;
    for_each_wave(shortest_wave(r), [&](const Wave& m) {
        const double a = amplitude(r, m), q = unit * std::hypot(m.x, m.y);
        sum.height += 2 * a * a;
        sum.slope += 2 * a * a * q * q;
    });
    return sum;
}

/// Of the amplitudes, for the prescribed rms slope [m].
double scale(const Roughness& r) {
    return r.rms_slope / std::sqrt(moments(r).slope);
}

/// Uniform in [0, 2 pi): the upper 53 bits. std's distributions differ between libraries.
double random_phase(std::mt19937_64& bits) {
    return 2 * std::numbers::pi * std::ldexp(static_cast<double>(bits() >> 11), -53);
}

struct FreeBuffer {
    void operator()(void* p) const { fftw_free(p); }
};

/// Half the complex spectrum, m_x >= 0, fastest in x.
class Spectrum {
  public:
    explicit Spectrum(int n)
        : n_(n),
          columns_(n / 2 + 1),
          values_(fftw_alloc_complex(static_cast<std::size_t>(columns_) * n)) {
        if (!values_) throw std::bad_alloc();
        std::fill_n(&values_[0][0], 2 * static_cast<std::size_t>(columns_) * n, 0.0);
    }

    void set(const Wave& m, double amplitude, double phase) {
        const double re = amplitude * std::cos(phase), im = amplitude * std::sin(phase);
        if (m.x >= 0) put(m, re, im);
        if (m.x <= 0) put({-m.x, -m.y}, re, -im);  // the opposite wave
    }

    std::vector<double> surface() {
        std::vector<double> out(static_cast<std::size_t>(n_) * n_);
        fftw_plan plan = fftw_plan_dft_c2r_2d(n_, n_, values_.get(), out.data(), FFTW_ESTIMATE);
        fftw_execute(plan);
        fftw_destroy_plan(plan);
        return out;
    }

  private:
    void put(const Wave& m, double re, double im) {
        const int row = m.y >= 0 ? m.y : m.y + n_;
        fftw_complex& to = values_[static_cast<std::size_t>(row) * columns_ + m.x];
        to[0] = re;
        to[1] = im;
    }

    int n_, columns_;
    std::unique_ptr<fftw_complex[], FreeBuffer> values_;
};

}  // namespace

HeightMap make_roughness(const Roughness& roughness, int n) {
    check(roughness);
    const int waves = shortest_wave(roughness);
    if (n <= 2 * waves)
        throw InputError(fmt::format(
            "roughness: {} nodes in a period of {:.6g} m do not resolve waves of {:.6g} m; take "
            "more than {}",
            n, roughness.long_wavelength, roughness.short_wavelength, 2 * waves));
    require_memory(fmt::format("roughness of {} x {} nodes", n, n), 2. * sizeof(double) * n * n,
                   "enlarge indenter.roughness.short_wavelength");
    const double height = scale(roughness);
    std::mt19937_64 bits(static_cast<std::uint64_t>(roughness.seed));
    Spectrum spectrum(n);
    for_each_wave(waves, [&](const Wave& m) {
        spectrum.set(m, height * amplitude(roughness, m), random_phase(bits));
    });
    const double spacing = roughness.long_wavelength / n;
    return {n, n, {spacing, spacing}, spectrum.surface()};
}

int fewest_roughness_nodes(const Roughness& roughness) {
    check(roughness);
    int n = 8 * std::max(1, shortest_wave(roughness));
    auto is_fast = [](int k) {
        for (const int prime : {2, 3, 5})
            while (k % prime == 0) k /= prime;
        return k == 1;
    };
    while (!is_fast(n)) n += 2;
    return n;
}

std::vector<double> spectral_density(const Roughness& roughness,
                                     const std::vector<double>& wave_numbers) {
    check(roughness);
    const double unit = 2 * std::numbers::pi / roughness.long_wavelength;
    const double height = scale(roughness);
    std::vector<double> densities;
    for (const double q : wave_numbers)
        densities.push_back(std::pow(height * amplitude(roughness, q / unit) / unit, 2));
    return densities;
}

double rms_height(const Roughness& roughness) {
    check(roughness);
    const Moments m = moments(roughness);
    return roughness.rms_slope * std::sqrt(m.height / m.slope);
}

}  // namespace tricontact::contact
