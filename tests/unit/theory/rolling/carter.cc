#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/creep_law.h"

namespace tricontact::theory::carter_test {
namespace {

constexpr int n_points = 20000;

/// Slip over rolled way in units of mu a/R: with p0 = E* a/(2 R) the strain of the half-plane is
/// -2/(pi E*) PV∫ tau(s)/(x - s) ds = -(mu a/R) 1/pi PV∫; midpoint rule, the singularity taken off.
double slip_ratio(double x, double f) {
    const double here = carter_traction(x, f), h = 2. / n_points;
    double integral = here * std::log((1 + x) / (1 - x));
    for (int i = 0; i < n_points; ++i) {
        const double s = -1 + (i + .5) * h;
        if (std::abs(x - s) > h / 4) integral += h * (carter_traction(s, f) - here) / (x - s);
    }
    return carter_creepage_ratio(f) - integral / std::numbers::pi;
}

TEST(Carter, TractionCarriesTheForce) {
    for (const double f : {0.1, 0.56, 0.9, 1.0}) {
        double sum = 0;
        for (int i = 0; i < n_points; ++i)
            sum += 2. / n_points * carter_traction(-1 + (2 * i + 1.) / n_points, f);
        // F_N = pi/2 p0 a; the midpoint rule loses 1e-6 at the ellipses' ends.
        EXPECT_NEAR(sum / (std::numbers::pi / 2), f, 2e-6) << f;
    }
}

TEST(Carter, SticksFromTheLeadingEdgeAndSlipsAlongTheTractionBehind) {
    for (const double f : {0.3, 0.75}) {
        const double c = carter_stick_ratio(f), end = 1 - 2 * c;
        for (const double x : {end + .1 * c, 1 - c, 1 - .1 * c})
            // The midpoint rule beside square roots: (1/20000)^(1/2) of a cell's share, 1e-4.
            EXPECT_NEAR(slip_ratio(x, f), 0, 1e-4) << f << ' ' << x;
        for (const double x : {-.9, (end - 1) / 2, end - .05})
            EXPECT_GT(slip_ratio(x, f), 1e-3) << f << ' ' << x;
        EXPECT_LE(carter_traction(1 - c, f), std::sqrt(1 - (1 - c) * (1 - c)));
    }
}

TEST(Carter, ForceAndCreepageAreInverse) {
    for (const double f : {1e-9, 0.2, 0.99, 1.0})
        EXPECT_NEAR(carter_force_ratio(carter_creepage_ratio(f)) / f, 1, 1e-14) << f;
    EXPECT_EQ(carter_force_ratio(3), 1);
}

TEST(Carter, RefusesWhatIsOutOfRange) {
    EXPECT_THROW(carter_creepage_ratio(1.01), std::domain_error);
    EXPECT_THROW(carter_stick_ratio(-0.1), std::domain_error);
    EXPECT_THROW(carter_force_ratio(-0.1), std::domain_error);
    EXPECT_THROW(carter_traction(std::nan(""), 0.5), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::carter_test
