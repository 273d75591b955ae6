// Power spectral densities of maps: single waves, synthetic roughness, measured pieces.

#include "contact/height_spectrum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/bodies/roughness.h"
#include "contact/cells.h"

namespace tricontact::contact::height_spectrum_test {
namespace {

constexpr double pi = std::numbers::pi;

/// Of n_x by n_y nodes, by a function of the place.
template <typename Height>
HeightMap map_of(int n_x, int n_y, Vector2 spacing, Height height) {
    HeightMap map{n_x, n_y, spacing, {}};
    for (int j = 0; j < n_y; ++j)
        for (int i = 0; i < n_x; ++i) map.height.push_back(height(i * spacing[0], j * spacing[1]));
    return map;
}

/// How many waves of an n by n map lie in the ring of m waves per side.
int waves_in_ring(int n, int m) {
    int count = 0;
    for (int j = -n / 2; j <= n / 2; ++j)
        for (int i = -n / 2; i <= n / 2; ++i) count += std::lround(std::hypot(i, j)) == m;
    return count;
}

// ∫ C d^2q is the mean square A^2/2 of a single wave, all in its ring.
TEST(HeightSpectrum, OfASingleWave) {
    const double length = 3e-3, a = 2e-6, unit = 2 * pi / length;
    for (const auto& [m_x, m_y] : {std::pair(3, 4), {5, 0}, {0, -5}}) {
        const HeightMap map = map_of(33, 33, {length / 33, length / 33}, [&](double x, double y) {
            return 7e-6 + a * std::cos(unit * (m_x * x + m_y * y) + .3);
        });
        const HeightSpectrum s = height_spectrum(map, MapEdges::repeat);
        ASSERT_EQ(s.density.size(), 16U);  // up to two nodes per wave
        const double all = a * a / 2 / (unit * unit);
        for (std::size_t k = 0; k < s.density.size(); ++k)
            EXPECT_NEAR(s.density[k] * waves_in_ring(33, static_cast<int>(k) + 1) / all,
                        k == 4 ? 1 : 0, 1e-12)
                << k;
        EXPECT_NEAR(s.wave_number[4] / unit, 5, .5);  // of the ring
    }
}

const Roughness rough{.hurst = .7,
                      .rms_slope = .2,
                      .long_wavelength = 2e-3,
                      .roll_off = .25e-3,
                      .short_wavelength = .04e-3,
                      .seed = 3};

TEST(HeightSpectrum, OfSyntheticRoughnessIsThePrescribedOne) {
    const HeightSpectrum s = height_spectrum(make_roughness(rough, 128), MapEdges::repeat);
    const auto due = spectral_density(rough, s.wave_number);
    const double unit = 2 * pi / rough.long_wavelength;
    for (std::size_t k = 0; k < due.size(); ++k) {
        const double m = s.wave_number[k] / unit;
        if (m < 7) {  // the plateau
            EXPECT_NEAR(s.density[k] / due[k], 1, 1e-12) << m;
        }
        // Over a ring q^-3.4 has a mean (3.4 4.4/24)/m^2 above its middle.
        if (m > 10 && m < 49) {
            EXPECT_NEAR(s.density[k] / due[k], 1, .8 / m / m + .02 / m) << m;
        }
        if (m > 51) {
            EXPECT_EQ(due[k], 0);
            EXPECT_LT(s.density[k] / due[0], 1e-25);
        }
    }
    EXPECT_EQ(spectral_density(rough, {.5 * unit}).front(), 0);
}

TEST(HeightSpectrum, PrescribedDensityHoldsTheMeanSquare) {
    const double unit = 2 * pi / rough.long_wavelength;
    std::vector<double> q;
    for (int j = -51; j <= 51; ++j)
        for (int i = -51; i <= 51; ++i) q.push_back(unit * std::hypot(i, j));
    double height = 0, slope = 0;
    const auto density = spectral_density(rough, q);
    for (std::size_t k = 0; k < q.size(); ++k) {
        height += density[k] * unit * unit;
        slope += density[k] * q[k] * q[k] * unit * unit;
    }
    EXPECT_NEAR(std::sqrt(height) / rms_height(rough), 1, 1e-12);
    EXPECT_NEAR(std::sqrt(slope) / rough.rms_slope, 1, 1e-12);
}

// A wave that does not fit into the piece, upon a tilted plane: in the right ring, and with its
// mean square but for what the window makes of so few waves.
TEST(HeightSpectrum, OfAPieceThatDoesNotRepeatItself) {
    const double h = 1e-6, a = 3e-7, q = 2 * pi / (9.7 * h);
    const HeightMap map = map_of(160, 120, {h, h}, [&](double x, double y) {
        return .05 * x - .2 * y + a * std::sin(q * (.6 * x + .8 * y));
    });
    const HeightSpectrum s = height_spectrum(map, MapEdges::open);
    const auto highest = std::max_element(s.density.begin(), s.density.end()) - s.density.begin();
    const double width = 2 * pi / (120 * h);
    EXPECT_NEAR(s.wave_number[highest], q, width);
    double all = 0;
    for (std::size_t k = 0; k < s.density.size(); ++k)
        all += s.density[k] * 2 * pi * s.wave_number[k] * width;
    EXPECT_NEAR(all / (a * a / 2), 1, .02);
    // Without the window its ends would be taken for steps: C ~ q^-3 far from the wave.
    EXPECT_LT(s.density.back() / s.density[highest], 1e-7);
}

TEST(HeightSpectrum, OfACaseIsThatOfItsCells) {
    Case c;
    c.indenter.shape = Case::Shape::paraboloid;
    c.indenter.radius = 10e-3;
    c.indenter.roughness = rough;
    c.substrate = {3e6, .5};
    c.friction.coefficient = .5;
    c.load.normal_force = .1;
    c.of<contact::Cells>().spacing = rough.long_wavelength / 128;
    const HeightSpectrum s = surface_spectrum(c),
                         due = height_spectrum(make_roughness(rough, 128), MapEdges::repeat);
    ASSERT_EQ(s.density.size(), due.density.size());
    for (std::size_t k = 0; k < s.density.size(); ++k)
        EXPECT_NEAR(s.density[k], due.density[k], 1e-10 * due.density[0]) << k;
}

}  // namespace
}  // namespace tricontact::contact::height_spectrum_test
