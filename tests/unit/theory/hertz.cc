#include "theory/hertz.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

namespace tricontact::hertz_test {
namespace {

constexpr double pi = std::numbers::pi;

// All scales different from 1; consistent with E* = 3 F_N / (4 a d).
contact::HalfSpaceScales example() {
    contact::HalfSpaceScales s{};
    s.contact_radius = 4.5e-3;
    s.indentation = 0.5e-3;
    s.normal_force = 21;
    s.peak_pressure = 1.5 * s.normal_force / (pi * s.contact_radius * s.contact_radius);
    return s;
}

TEST(Hertz, PressureCarriesTheNormalForce) {
    const auto s = example();
    auto ring = [&](double r) { return 2 * pi * r * theory::hertz_pressure(s, r); };
    boost::math::quadrature::tanh_sinh<double> quadrature;
    // quadrature with an end point square root: full precision but for a few roundings
    EXPECT_NEAR(quadrature.integrate(ring, 0., s.contact_radius) / s.normal_force, 1, 1e-12);
    EXPECT_EQ(theory::hertz_pressure(s, 1.001 * s.contact_radius), 0);
}

TEST(Hertz, DisplacementFollowsTheParaboloidInside) {
    const auto s = example();
    const double radius = s.contact_radius * s.contact_radius / s.indentation;
    for (const double r : {0., 1e-3, 3.3e-3, 4.5e-3}) {
        const double expected = s.indentation - r * r / (2 * radius);
        EXPECT_NEAR(theory::hertz_surface_displacement(s, r) / expected, 1, 1e-14) << r;
    }
}

TEST(Hertz, DisplacementIsSmoothAtTheEdge) {
    const auto s = example();
    const double inside = theory::hertz_surface_displacement(s, s.contact_radius * (1 - 1e-9));
    const double outside = theory::hertz_surface_displacement(s, s.contact_radius * (1 + 1e-9));
    // Slope -d/a on both sides: the difference is 2e-9 d, to the curvature's share of 1e-13.
    EXPECT_NEAR((inside - outside) / s.indentation, 2e-9, 1e-12);
}

TEST(Hertz, DisplacementOutsideSolvesBoussinesq) {
    // On the surface outside, u_z(r) = 1/(pi E*) ∫ p / distance dA: rings by the elliptic integral
    // 4 K(2 sqrt(r t)/(r + t))/(r + t).
    const auto s = example();
    const double modulus = 3 * s.normal_force / (4 * s.contact_radius * s.indentation);
    boost::math::quadrature::tanh_sinh<double> quadrature;
    for (const double rho : {1.5, 4., 99., 101., 1e4}) {
        const double r = rho * s.contact_radius;
        auto ring = [&](double t) {
            const double k = 2 * std::sqrt(r * t) / (r + t);
            return theory::hertz_pressure(s, t) * t * 4 * std::comp_ellint_1(k) / (r + t);
        };
        const double u = quadrature.integrate(ring, 0., s.contact_radius) / (pi * modulus);
        // Up to the switch at rho = 100 cancellation leaves 12 digits.
        EXPECT_NEAR(theory::hertz_surface_displacement(s, r) / u, 1, 1e-11) << rho;
    }
}

TEST(Hertz, RefusesNegativeRadii) {
    EXPECT_THROW(theory::hertz_pressure(example(), -1e-3), std::domain_error);
    EXPECT_THROW(theory::hertz_surface_displacement(example(), std::nan("")), std::domain_error);
}

}  // namespace
}  // namespace tricontact::hertz_test
