// Nowell and Hills' line contact against superposed point forces, its own resultants, and closed
// forms of Johnson (1985) for stresses on the axis and at the edge.

#include "theory/bulk_stress_line.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>

namespace tricontact::theory::bulk_stress_line_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr contact::Material steel{206e9, .3};
const double e_star = steel.young / (2 * (1 - steel.poisson * steel.poisson));

BulkStressLine loaded(double force_ratio, double bulk_stress) {
    return bulk_stress_line(e_star, steel, .02, 2e5, .6, force_ratio, bulk_stress);
}

double integral(const BulkStressLine& line, const std::function<double(double)>& f) {
    const double a = line.half_width, c = line.stick_half_width, e = line.stick_centre;
    boost::math::quadrature::tanh_sinh<double> rule(9);
    double sum = 0;
    const double ends[] = {-a, e - c, e + c, a};
    for (int k = 0; k < 3; ++k)
        if (ends[k + 1] > ends[k]) sum += rule.integrate(f, ends[k], ends[k + 1], 1e-10);
    return sum;
}

TEST(BulkStressLine, CarriesTheForceAndStretchesWithTheHalfSpaceWhereItSticks) {
    for (const double ratio : {.5, -.5})
        for (const double bulk : {0., 8e7, -5e7}) {
            const BulkStressLine line = loaded(ratio, bulk);
            ASSERT_TRUE(line.holds());
            // e = sigma a/(4 mu p0) of equal bodies.
            EXPECT_NEAR(
                line.stick_centre,
                std::copysign(1, ratio) * bulk * line.half_width / (4 * .6 * line.peak_pressure),
                1e-12 * line.half_width);
            const double force = integral(line, [&](double x) { return line.traction(x); });
            EXPECT_NEAR(force / (ratio * .6 * 2e5), 1, 1e-8);
        }
}

// Flamant's radial stresses, integrated (Johnson 1985, eq. 2.15 and 2.18).
TEST(BulkStressLine, StressesAreThoseOfPointForces) {
    const BulkStressLine line = loaded(.6, 6e7);
    const double a = line.half_width;
    for (const auto& [at_x, at_z] : {std::pair(.3, .4), std::pair(-1.1, .2), std::pair(.9, 1.)}) {
        const double x = at_x * a, z = at_z * a;
        std::array<double, 3> sum{6e7, 0, 0};  // XX, ZZ, XZ
        const auto add = [&](int k, auto part) {
            sum[k] += integral(line, [&](double s) {
                const double p = line.peak_pressure * std::sqrt(std::max(0., 1 - s * s / a / a));
                const double dx = x - s, r2 = dx * dx + z * z;
                return -2 / pi * (p * z + line.traction(s) * dx) / (r2 * r2) * part(dx);
            });
        };
        add(0, [&](double dx) { return dx * dx; });
        add(1, [&](double) { return z * z; });
        add(2, [&](double dx) { return dx * z; });
        const auto stress = line.stress(steel, x, z);
        EXPECT_NEAR(stress[0], sum[0], 1e-7 * line.peak_pressure);
        EXPECT_NEAR(stress[2], sum[1], 1e-7 * line.peak_pressure);
        EXPECT_NEAR(stress[5], sum[2], 1e-7 * line.peak_pressure);
        EXPECT_EQ(stress[1], .3 * (stress[0] + stress[2]));
    }
}

TEST(BulkStressLine, SurfaceAndAxisOfJohnson) {
    const BulkStressLine line = loaded(.6, 6e7), still = loaded(0, 0);
    const double a = line.half_width, p0 = line.peak_pressure;
    for (const double at : {-.95, -.2, .1, .7}) {
        const auto stress = line.stress(steel, at * a, 0);
        EXPECT_NEAR(stress[2], -p0 * std::sqrt(1 - at * at), 1e-12 * p0);
        EXPECT_NEAR(stress[5], -line.traction(at * a), 1e-12 * p0);
    }
    // Eq. 4.46.
    for (const double z : {.2, .78, 2.}) {
        const auto stress = still.stress(steel, 0, z * a);
        const double root = std::sqrt(1 + z * z);
        EXPECT_NEAR(stress[0], -p0 * ((1 + 2 * z * z) / root - 2 * z), 1e-12 * p0);
        EXPECT_NEAR(stress[2], -p0 / root, 1e-12 * p0);
    }
}

TEST(BulkStressLine, TensionAtTheTrailingEdge) {
    for (const double ratio : {.3, 1., -.3})
        for (const double bulk : {0., 7e7}) {
            const BulkStressLine line = loaded(ratio, bulk);
            const double edge = -std::copysign(line.half_width, ratio);
            EXPECT_NEAR(line.trailing_stress() / line.stress(steel, edge, 0)[0], 1, 1e-12);
        }
    // Sliding: 2 mu p0; partial slip: 2 mu p0 sqrt(1 - (c/a)^2) = 2 mu p0 sqrt(F_T/(mu F_N)).
    const double sliding = 2 * .6 * loaded(1, 0).peak_pressure;
    EXPECT_NEAR(loaded(1, 0).trailing_stress() / sliding, 1, 1e-12);
    EXPECT_NEAR(loaded(.36, 0).trailing_stress() / sliding, .6, 1e-12);
    EXPECT_FALSE(loaded(.1, 3e8).holds());
    EXPECT_TRUE(loaded(0, 0).holds());
}

}  // namespace
}  // namespace tricontact::theory::bulk_stress_line_test
