#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "mdr/line_surface.h"

namespace tricontact::back_transform_test {
namespace {

using std::numbers::pi;

double back_transform(const std::vector<double>& x, const std::vector<double>& q, double r) {
    return mdr::back_transform(mdr::slopes_of(x, q), mdr::abel_weights(x, r));
}

// Polygon of q = 1 - x^2/a^2 on n pieces.
std::pair<std::vector<double>, std::vector<double>> parabola(double a, int n) {
    std::vector<double> x, q;
    for (int k = 0; k <= n; ++k) {
        x.push_back(a * k / n);
        q.push_back(1 - (1. * k / n) * k / n);
    }
    return {x, q};
}

double hertz_error(int n, double rho) {
    const double a = 3.;
    const auto [x, q] = parabola(a, n);
    const double exact = 2 / (pi * a) * std::sqrt(1 - rho * rho);
    return std::abs(back_transform(x, q, rho * a) / exact - 1);
}

TEST(MdrBackTransform, HertzPressureConverges) {
    for (const int n : {100, 201, 400})
        for (const double rho : {0., .123, .5, .87, .97})
            // pieces on the same slope as the parabola only in their middle: O(h^(3/2)) at the
            // singular end of the integral, pi^2/36 h at the centre
            EXPECT_LT(hertz_error(n, rho), .3 / n) << n << ' ' << rho;
    // at the centre the coefficient is known: first order exactly
    EXPECT_NEAR(std::log2(hertz_error(100, 0) / hertz_error(200, 0)), 1, .05);
    EXPECT_NEAR(std::log2(hertz_error(201, 0) / hertz_error(402, 0)), 1, .05);
}

// A cone's line load is a straight line: only the rounded first piece is not exact.
TEST(MdrBackTransform, StraightLineIsExact) {
    const std::vector<double> x{0, 1e-9, 2.5}, q{2.5, 2.5 - 1e-9, 0};
    for (const double r : {.01, .7, 2.4, 2.5})
        EXPECT_NEAR(back_transform(x, q, r), std::acosh(2.5 / r) / pi, 1e-14) << r;
    EXPECT_EQ(back_transform(x, q, 2.6), 0);
}

// ∫ p 2 pi r dr = 2 ∫_0^a q dx for any polygon whose first piece is flat.
TEST(MdrBackTransform, KeepsTheForce) {
    const std::vector<double> x{0, .3, .5, 1.1, 1.6}, q{2, 2, 1.2, .9, 0};
    double line = 0, disc = 0;
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        line += (x[k + 1] - x[k]) * (q[k] + q[k + 1]);
        auto ring = [&](double r) { return 2 * pi * r * back_transform(x, q, r); };
        disc += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(ring, x[k], x[k + 1],
                                                                              15, 1e-12);
    }
    EXPECT_NEAR(disc / line, 1, 1e-9);  // square root cusps at every kink
}

TEST(MdrBackTransform, RefusesMalformedLoads) {
    const std::vector<double> x{0, 1}, q{1, 0}, shifted{.1, 1}, one{0};
    EXPECT_THROW(back_transform(x, one, .5), std::domain_error);
    EXPECT_THROW(back_transform(one, one, .5), std::domain_error);
    EXPECT_THROW(back_transform(shifted, q, .5), std::domain_error);
    EXPECT_THROW(back_transform(x, q, -1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::back_transform_test
