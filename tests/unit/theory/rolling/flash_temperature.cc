// Moving heat sources: closed forms beside their integrals and published numbers.

#include "theory/rolling/flash_temperature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace tricontact::flash_temperature_test {
namespace {

/// int q(s) (x - s)^(-1/2) ds = 2 int q(x - w^2) dw, by midpoints.
template <class Source>
double integral(double x, const Source& source) {
    constexpr int n = 200000;
    const double end = std::sqrt(x + 1);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double w = end * (i + .5) / n;
        sum += source(x - w * w);
    }
    return 2 * sum * end / n;
}

TEST(FlashTemperature, UniformBand) {
    EXPECT_EQ(theory::uniform_heating(-1.5), 0);
    // 2 q/b (2 a/(pi V))^(1/2) at the trailing edge, Carslaw and Jaeger (1959), 2.9 (8).
    EXPECT_NEAR(theory::uniform_heating(1), 2 * std::sqrt(2.), 1e-14);
    for (const double x : {-.5, .3, 1., 1.7, 8.})
        EXPECT_NEAR(theory::uniform_heating(x),
                    integral(x, [](double s) { return std::abs(s) <= 1 ? 1. : 0.; }), 1e-4);
}

TEST(FlashTemperature, EllipticBand) {
    for (const double x : {-.99, -.5, 0., .4, .9, 1.})
        EXPECT_NEAR(theory::elliptic_heating(x),
                    integral(x, [](double s) { return std::sqrt(std::fmax(1 - s * s, 0)); }), 1e-6);
    // int (1 + s)^(1/2) ds over the band.
    EXPECT_NEAR(theory::elliptic_heating(1), 4 * std::sqrt(2.) / 3, 1e-14);
    EXPECT_NEAR(theory::elliptic_heating(-1), 0, 1e-14);
    EXPECT_THROW(theory::elliptic_heating(1.1), std::domain_error);
}

// Jaeger (1942) recommends the formula of fast sources from L = Pe = 5 or 10 on. What is left falls
// as Pe^(-1) with a logarithm: K_0 near the trailing edge.
TEST(FlashTemperature, FlowIntoTheDepthAlone) {
    double before = 1;
    for (const double peclet : {1., 5., 10., 20., 100., 1e3, 1e4}) {
        const double error = theory::band_error(peclet);
        EXPECT_GT(error, 0);
        EXPECT_LT(error, before);
        before = error;
    }
    EXPECT_NEAR(theory::band_error(5), .0412, 1e-4);
    EXPECT_NEAR(theory::band_error(10), .0239, 1e-4);
    EXPECT_THROW(theory::band_error(0), std::domain_error);
}

// A slow band: in the limit the resting source's logarithm, T = 2 q a/(pi lambda) [ln(2/Pe) - gamma
// + 1] + ..., of which flow into the depth alone has 2 q/b (2 a/(pi V))^(1/2).
TEST(FlashTemperature, SlowBand) {
    constexpr double peclet = 1e-4, gamma = .5772156649015329;
    // int_{-Pe}^{Pe} e^u K_0 du -> 2 Pe (1 - gamma - ln(Pe/2)), beside 2 (pi Pe)^(1/2).
    const double exact = 2 * peclet * (1 - gamma - std::log(peclet / 2));
    EXPECT_NEAR((1 + theory::band_error(peclet)) * exact / (2 * std::sqrt(M_PI * peclet)), 1, 1e-3);
}

}  // namespace
}  // namespace tricontact::flash_temperature_test
