#include "theory/rolling/body_rolling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/verification/bodies_cases.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/rolling/oscillating_rolling.h"

namespace tricontact::body_rolling_test {
namespace {

using contact::Case;
using std::numbers::pi;

Case body_case(Case::Shape shape, double exponent = 0) {
    Case c;
    c.indenter.shape = shape;
    c.indenter.radius = .04;
    c.indenter.radius_y = .11;
    c.indenter.exponent = exponent;
    c.indenter.angle = .1;
    c.indenter.flat_radius = .003;
    c.substrate = {5.2e6, .4};
    c.friction.coefficient = .3;
    c.load.normal_force = 12;
    c.rolling = Case::Rolling{};
    return c;
}

/// ∫ p dA over F_N.
template <typename Pressure>
double carried(Pressure pressure) {
    // rho = sin t: the square root at the edge vanishes
    auto ring = [&](double t) { return 2 * pressure(std::sin(t)) * std::sin(t) * std::cos(t); };
    double sum = 0;
    for (int i = 0; i < 40; ++i)
        sum += boost::math::quadrature::gauss<double, 15>::integrate(ring, pi / 80 * i,
                                                                     pi / 80 * (i + 1));
    return sum;
}

TEST(BodyPressure, CarriesTheLoad) {
    for (const double n : {1.5, 2., 3., 4., 10.})
        EXPECT_NEAR(carried([=](double rho) { return theory::power_law_pressure(n, rho); }), 1,
                    n < 2 ? 1e-6 : 1e-9)  // below 2 the slope at the centre is infinite
            << n;
    for (const double flat : {.1, .5, .9})
        EXPECT_NEAR(carried([=](double rho) { return theory::rounded_punch_pressure(flat, rho); }),
                    1, 1e-4)  // p has a logarithm beside the edge of the flat part
            << flat;
}

TEST(BodyPressure, HasItsClosedForms) {
    for (const double rho : {.05, .4, .93}) {
        const double s = std::sqrt(1 - rho * rho);
        EXPECT_NEAR(theory::power_law_pressure(2, rho), 1.5 * s, 1e-10);
        EXPECT_NEAR(theory::power_law_pressure(1, rho), std::acosh(1 / rho), 1e-14);
        EXPECT_NEAR(theory::power_law_pressure(4, rho), 2.5 * (rho * rho * s + s * s * s / 3),
                    1e-10);
        // hardly any flat part: a paraboloid, to the order b/a
        EXPECT_NEAR(theory::rounded_punch_pressure(1e-6, rho), 1.5 * s, 1e-5);
        // hardly rounded: Boussinesq's punch away from the edge, to the order (a - b)/a
        EXPECT_NEAR(theory::rounded_punch_pressure(.9999, rho), .5 / s, 1e-3 * .5 / s / s / s);
    }
    EXPECT_NEAR(theory::power_law_pressure(3, 0), theory::power_law_pressure(3, 1e-9), 1e-8);
    EXPECT_EQ(theory::power_law_pressure(3, 1.2), 0);
    EXPECT_THROW(theory::power_law_pressure(.9, .5), std::domain_error);
    EXPECT_THROW(theory::rounded_punch_pressure(1, .5), std::domain_error);
    EXPECT_THROW(theory::rounded_punch_pressure(.5, -.1), std::domain_error);
}

// The formulas of the header, and Hertz' case of them.
TEST(BodyRolling, PowerLawsHaveTheirFormulas) {
    for (const double n : {1., 1.5, 2., 3., 4.}) {
        const Case c = body_case(n == 1 ? Case::Shape::cone : Case::Shape::power_law, n);
        for (const double f : {0., .2, .56, .9, 1.})
            EXPECT_NEAR(theory::static_shift_ratio(c, f), 1 - std::pow(1 - f, n / (n + 1)), 1e-10);
        for (const double w : {0., .24, .7, 1.}) {
            const double limit = 1 - ((n + 1) * w - std::pow(w, n + 1)) / n;
            EXPECT_NEAR(verification::bed_limit(c, w), limit, 1e-13);
            if (!(limit > .01 && limit < .99)) continue;
            const double f = .8 * limit, u = *theory::bed_settled_shift_ratio(c, w, f);
            EXPECT_NEAR(1 - std::pow(1 - u, (n + 1) / n) - (n + 1) / n * w * u, f, 1e-10);
            EXPECT_FALSE(theory::bed_settled_shift_ratio(c, w, limit + .001));
            // u_lim = 1 - g(W)/d
            EXPECT_NEAR(*theory::bed_settled_shift_ratio(c, w, limit - 1e-12), 1 - std::pow(w, n),
                        1e-5);
        }
    }
    const Case square = body_case(Case::Shape::power_law, 2);
    EXPECT_NEAR(*theory::bed_settled_shift_ratio(square, .3, .4),
                *theory::settled_shift_ratio(.3, .4), 1e-10);
    EXPECT_NEAR(*theory::shakedown_limit(square, .3), theory::shakedown_limit(.3), 1e-13);
}

/// (1/F_N) ∫ min p dA by looking at the pressures themselves: the path in steps of the cells, so
/// that it passes over the nearest point.
template <typename Pressure>
double limit_by_brute_force(Pressure pressure, int cells_in_path, int cells_in_radius) {
    const double h = 1. / cells_in_radius;
    double sum = 0;
    for (int i = -cells_in_radius; i <= cells_in_radius; ++i)
        for (int j = 0; j <= cells_in_radius; ++j) {
            double least = 1e9;
            for (int k = -cells_in_path; k <= cells_in_path; ++k)
                least = std::min(least, pressure(std::hypot((i + k) * h, (j + .5) * h)));
            sum += 2 * h * h * least;
        }
    return sum / pi;
}

// On a lattice of 1/80 the edge is cut by square cells: h^(3/2) of the load at most.
TEST(BodyRolling, LimitIsTheLeastPressureOnThePath) {
    auto table_of = [](auto pressure) {
        std::vector<double> table;
        for (int i = 0; i <= 4000; ++i) table.push_back(pressure(i / 2000.));
        return [table](double rho) { return table[std::min(4000, int(rho * 2000 + .5))]; };
    };
    for (const double n : {1.5, 4., 10.}) {
        const auto p = table_of([=](double rho) { return theory::power_law_pressure(n, rho); });
        const Case c = body_case(Case::Shape::power_law, n);
        for (const int path : {8, 32})
            EXPECT_NEAR(*theory::shakedown_limit(c, path / 80.), limit_by_brute_force(p, path, 80),
                        1.5e-3)
                << n << ' ' << path;
        EXPECT_NEAR(*theory::shakedown_limit(c, *theory::amplitude_limit(c, .4)), .4, 1e-4);
    }
    const Case punch = body_case(Case::Shape::rounded_punch);
    const double flat = .003 / contact::half_space_scales(punch).contact_radius;
    const auto p = table_of([=](double rho) { return theory::rounded_punch_pressure(flat, rho); });
    EXPECT_NEAR(*theory::shakedown_limit(punch, .2), limit_by_brute_force(p, 16, 80), 1.5e-3);
    EXPECT_LT(*theory::shakedown_limit(punch, .2), verification::bed_limit(punch, .2) - .001);
}

TEST(BodyRolling, EllipsesAreStretchedCircles) {
    Case c = body_case(Case::Shape::ellipsoid);
    const auto s = contact::half_space_scales(c);
    for (const auto& [angle, axis] :
         {std::pair(0., s.half_widths[0]), {pi / 2, s.half_widths[1]}}) {
        c.rolling->angle = angle;
        EXPECT_NEAR(*theory::shakedown_limit(c, .3 * axis / s.contact_radius),
                    theory::shakedown_limit(.3), 1e-12);
        EXPECT_NEAR(*theory::amplitude_limit(c, .4) * s.contact_radius / axis,
                    theory::amplitude_limit(.4), 1e-12);
    }
    EXPECT_EQ(theory::static_shift_ratio(c, .56), theory::static_shift_ratio(.56));
    EXPECT_FALSE(theory::bed_settled_shift_ratio(c, .3, .2));
    EXPECT_THROW(theory::shakedown_limit(c, 1.1), std::domain_error);
    EXPECT_THROW(theory::static_shift_ratio(c, -.1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::body_rolling_test
