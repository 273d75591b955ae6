// Synthetic roughness: its spectrum, its moments, its phases.

#include "contact/bodies/roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "contact/base/error.h"

namespace tricontact::roughness_test {
namespace {

using contact::HeightMap;
using contact::make_roughness;
using contact::Roughness;

const Roughness surface{.hurst = .8,
                        .rms_slope = .3,
                        .long_wavelength = 2e-3,
                        .roll_off = .4e-3,
                        .short_wavelength = .05e-3,
                        .seed = 5};

/// Mean square of the surface's wave m_x, m_y by the definition of a Fourier coefficient.
double power(const HeightMap& map, int m_x, int m_y) {
    std::complex<double> sum = 0;
    const std::complex<double> one(0, 1);
    for (int j = 0; j < map.n_y; ++j)
        for (int i = 0; i < map.n_x; ++i)
            sum += map.at(i, j) * std::exp(-one * (2 * std::numbers::pi * (m_x * i + m_y * j) /
                                                   static_cast<double>(map.n_x)));
    return std::norm(sum) / std::pow(map.height.size(), 2);
}

TEST(Roughness, HasTheSpectrumItPromises) {
    const HeightMap map = make_roughness(surface, 96);  // 40 waves: resolved by more than 80
    const double plateau = power(map, 1, 0);
    for (const auto& [x, y] : {std::pair(3, -4), {0, 2}, {-2, 1}, {5, 0}})  // up to the roll-off
        EXPECT_NEAR(power(map, x, y) / plateau, 1, 1e-10) << x << ' ' << y;
    for (const auto& [x, y] : {std::pair(6, 8), {-24, 32}, {40, 0}, {13, -7}})
        EXPECT_NEAR(power(map, x, y) / plateau, std::pow(std::hypot(x, y) / 5, -3.6), 1e-10)
            << x << ' ' << y;
    for (const auto& [x, y] : {std::pair(0, 0), {41, 0}, {30, 30}})  // mean height and cut-off
        EXPECT_LT(power(map, x, y) / plateau, 1e-25) << x << ' ' << y;
}

// Differences of step h see of a wave q the part sin(qh/2)/(qh/2): their rms slope is short of the
// surface's by O(h^2).
TEST(Roughness, HasTheSlopeItPromises) {
    double last = 0;
    for (const int n : {243, 486, 972}) {
        const double missing = 1 - rms_slope(make_roughness(surface, n)) / surface.rms_slope;
        EXPECT_GT(missing, 0);
        if (last > 0) {
            EXPECT_NEAR(last / missing, 4, .2);
        }
        last = missing;
    }
    EXPECT_LT(last, 2e-3);
}

TEST(Roughness, HeightsFollowFromTheSpectrum) {
    EXPECT_NEAR(rms_height(make_roughness(surface, 96)) / rms_height(surface), 1, 1e-12);
    // one wavelength alone: slope and height are in the ratio of its wave number
    Roughness one = surface;
    one.roll_off = one.short_wavelength = one.long_wavelength;
    EXPECT_NEAR(rms_height(one) * 2 * std::numbers::pi / one.long_wavelength / one.rms_slope, 1,
                1e-12);
}

TEST(Roughness, FinerLatticesSampleTheSameSurface) {
    const HeightMap coarse = make_roughness(surface, 90), fine = make_roughness(surface, 270);
    for (int j = 0; j < 90; ++j)
        for (int i = 0; i < 90; ++i)
            ASSERT_NEAR(coarse.at(i, j), fine.at(3 * i, 3 * j), 1e-12 * surface.roll_off);
}

// Skewness and excess kurtosis of a Gaussian vanish. Of this random sample of some 2 (L/lambda_r)^2
// = 128 independent patches they scatter by (6/128)^(1/2) = 0.2 and 0.4: three of these.
TEST(Roughness, HeightsAreGaussian) {
    Roughness wide = surface;
    wide.roll_off = wide.long_wavelength / 8;
    const HeightMap map = make_roughness(wide, 256);
    const double rms = rms_height(map);
    double third = 0, fourth = 0;
    for (const double z : map.height) {
        third += std::pow(z / rms, 3);
        fourth += std::pow(z / rms, 4);
    }
    const auto n = static_cast<double>(map.height.size());
    EXPECT_NEAR(third / n, 0, .6);
    EXPECT_NEAR(fourth / n, 3, 1.2);
    EXPECT_NE(third, 0);
}

TEST(Roughness, IsThatOfItsSeed) {
    const HeightMap map = make_roughness(surface, 96), again = make_roughness(surface, 96);
    EXPECT_EQ(map.height, again.height);
    Roughness other = surface;
    other.seed = 6;
    double correlation = 0;
    const HeightMap another = make_roughness(other, 96);
    for (std::size_t k = 0; k < map.height.size(); ++k)
        correlation += map.height[k] * another.height[k];
    correlation /= static_cast<double>(map.height.size()) * std::pow(rms_height(map), 2);
    EXPECT_LT(std::abs(correlation), .5);  // of some 50 independent patches: 0.14
}

void expect_refused(Roughness r, int n, const std::string& part) {
    try {
        make_roughness(r, n);
        ADD_FAILURE() << part;
    } catch (const contact::InputError& refused) {
        EXPECT_NE(std::string(refused.what()).find(part), std::string::npos) << refused.what();
    }
}

TEST(Roughness, RefusesWhatIsNoSurface) {
    Roughness r = surface;
    expect_refused(r, 80, "take more than 80");
    r.roll_off = .01e-3;
    expect_refused(r, 96, "wavelengths must obey");
    r = surface;
    r.rms_slope = 0;
    expect_refused(r, 96, "rms slope");
    r = surface;
    r.hurst = 1.1;
    expect_refused(r, 96, "hurst");
}

}  // namespace
}  // namespace tricontact::roughness_test
