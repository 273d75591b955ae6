#include "contact/bodies/roughness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "contact/base/error.h"
#include "contact/base/fftw.h"
#include "contact/base/memory.h"

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
    if (!is_positive_and_finite(r.rms_slope))
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
    const int columns = n / 2 + 1;  // half the complex spectrum, m_x >= 0, fastest in x
    const auto spectrum = fftw_zeros<FftwComplex>(static_cast<std::size_t>(columns) * n);
    const auto put = [&](int x, int y, double re, double im) {
        fftw_complex& to = spectrum[static_cast<std::size_t>(y >= 0 ? y : y + n) * columns + x];
        to[0] = re;
        to[1] = im;
    };
    for_each_wave(waves, [&](const Wave& m) {
        const double a = height * amplitude(roughness, m), phase = random_phase(bits);
        const double re = a * std::cos(phase), im = a * std::sin(phase);
        if (m.x >= 0) put(m.x, m.y, re, im);
        if (m.x <= 0) put(-m.x, -m.y, re, -im);  // the opposite wave
    });
    const double spacing = roughness.long_wavelength / n;
    HeightMap map{n, n, {spacing, spacing}, std::vector<double>(static_cast<std::size_t>(n) * n)};
    const FftwPlan plan(
        fftw_plan_dft_c2r_2d(n, n, spectrum.get(), map.height.data(), FFTW_ESTIMATE));
    fftw_execute(plan.get());
    return map;
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
