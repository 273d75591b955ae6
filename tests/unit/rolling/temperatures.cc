// Temperatures of both surfaces in steady rolling: closed forms of moving sources, and the heat
// equation of both bodies by finite differences.

#include "rolling/temperatures.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "rolling/rolling_report.h"
#include "tests/unit/rolling/problems.h"
#include "theory/rolling/flash_temperature.h"

namespace tricontact::rolling_temperatures_test {
namespace {

using contact::ContactHeat;
using contact::Surface;
using rolling_test::Rig;

constexpr double half_length = 3e-3, speed = 7, flux = 4e6;  // [m], [m/s], [W/m^2]
const ContactHeat unlike{{.conductivity = 50, .specific_heat = 450, .density = 7850},
                         {.conductivity = .9, .specific_heat = 800, .density = 2500}};

/// What `unit` times a closed form is, the heat of friction being shared.
double unit(const ContactHeat& heat) {
    return flux / (heat.indenter.effusivity() + heat.substrate.effusivity()) *
           std::sqrt(half_length / (std::numbers::pi * speed));
}

/// A row of `n` cells in contact about 0, as many ahead, twice as many behind; heat of friction
/// flux * `source`(x downstream over a).
template <class Source>
Surface heated_row(int n, const Source& source) {
    Surface s;
    s.n_x = 4 * n;
    s.n_y = 1;
    s.spacing = {2 * half_length / n, 1e-3};
    s.first = {-half_length + (.5 - 2 * n) * s.spacing[0], 0};
    s.normal_traction.assign(s.n_x, 0);
    s.dissipation.assign(s.n_x, 0);
    for (int i = 2 * n; i < 3 * n; ++i) {
        s.normal_traction[i] = 1;
        s.dissipation[i] = flux / speed * source(-s.x(i) / half_length);
    }
    return s;
}

// What is constant on cells is integrated exactly: in contact, behind it, and not at all ahead.
TEST(Temperatures, UniformSourceIsExact) {
    const Surface s = heated_row(9, [](double) { return 1.; });
    const auto rise = rolling::friction_heating(s, unlike, speed);
    for (int i = 0; i < s.n_x; ++i)
        EXPECT_NEAR(rise[i] / unit(unlike), theory::uniform_heating(-s.x(i) / half_length), 1e-12)
            << i;
}

double elliptic_error(int n) {
    const Surface s = heated_row(n, [](double x) { return std::sqrt(1 - x * x); });
    const double centre = rolling::friction_heating(s, unlike, speed)[2 * n + n / 2];
    return centre / unit(unlike) - theory::elliptic_heating(0);
}

// At the middle of three odd rows: order 3/2, by the slope of the source there and ahead.
TEST(Temperatures, EllipticSourceConvergesAtOrderThreeHalves) {
    const double coarse = elliptic_error(45), fine = elliptic_error(135),
                 finest = elliptic_error(405);
    EXPECT_LT(std::abs(coarse), 2e-3);
    EXPECT_NEAR(std::log(coarse / fine) / std::log(3.), 1.5, .1);
    EXPECT_NEAR(std::log(fine / finest) / std::log(3.), 1.5, .1);
}

/// Two bodies by finite volumes in time, each depth over kappa^(1/2): they touch from 0 to 1, from
/// where on no heat leaves. Surface temperatures of both at time `end`.
std::array<double, 2> by_differences(const ContactHeat& heat, double heating, double end) {
    constexpr int n = 300;
    constexpr double depth = 9, dz = depth / n, dt = .4 * dz * dz;
    const std::array bodies{heat.indenter, heat.substrate};
    const std::array b{bodies[0].effusivity(), bodies[1].effusivity()};
    std::array<std::vector<double>, 2> t;
    for (const int k : {0, 1}) t[k].assign(n, bodies[k].temperature);
    const auto share = [&] {
        t[0][0] = t[1][0] = (b[0] * t[0][0] + b[1] * t[1][0]) / (b[0] + b[1]);
    };
    share();
    for (double time = 0; time < end; time += dt) {
        const bool touch = time < 1;
        for (const int k : {0, 1}) {
            std::vector<double>& one = t[k];
            std::vector<double> next = one;
            // Half a cell at the surface; both halves share heat below.
            next[0] += 2 * dt / (dz * dz) * (one[1] - one[0]);
            if (touch) next[0] += 2 * dt / dz * heating / (b[0] + b[1]);
            for (int i = 1; i + 1 < n; ++i)
                next[i] += dt / (dz * dz) * (one[i - 1] - 2 * one[i] + one[i + 1]);
            one = next;
        }
        if (touch) share();
    }
    return {t[0][0], t[1][0]};
}

// Bodies of unlike effusivities and bulk temperatures, in contact and half a contact behind it: the
// heat equation knows no shares.
TEST(Temperatures, UnlikeBodiesAsTheHeatEquationHasThem) {
    ContactHeat heat = unlike;
    heat.indenter.temperature = 20;
    heat.substrate.temperature = 90;
    constexpr int n = 40;
    const Surface s = heated_row(n, [](double) { return 1.; });
    const auto t = rolling::surface_temperatures(s, heat, speed);
    // Time is over that of passing 2 a: q t^(1/2) has its unit.
    const double heating = flux * std::sqrt(2 * half_length / speed);
    for (const int behind : {n / 2, n, n + n / 2}) {
        const int i = 3 * n - behind;  // so many cells and a half behind the leading edge
        const auto [indenter, substrate] = by_differences(heat, heating, (behind - .5) / n);
        const double scale = 2 * unit(heat);
        EXPECT_NEAR(t.indenter[i], indenter, .01 * scale) << behind;
        EXPECT_NEAR(t.substrate[i], substrate, .01 * scale) << behind;
        EXPECT_EQ(std::abs(t.indenter[i] - t.substrate[i]) < 1e-9, behind <= n);
    }
    // Ahead nothing is known of the contact.
    EXPECT_EQ(t.indenter[3 * n], 20);
    EXPECT_EQ(t.substrate[3 * n], 90);
    // A tenth of the effusivity takes a tenth of the way to the other's temperature.
    EXPECT_NEAR(
        heat.substrate_share(),
        heat.substrate.effusivity() / (heat.substrate.effusivity() + heat.indenter.effusivity()),
        1e-15);
    EXPECT_LT(heat.touching_temperature(), 30);
}

// A rolled cylinder that slides all over: Hertz' pressure, 1 % of creepage. The highest temperature
// is that of the elliptic source, at the place that its closed form has.
TEST(Temperatures, SlidingCylinder) {
    const Rig rig{.n = 80};
    rolling::RollingProblem problem = rig.row(0);
    problem.drive.creepage[0] = 200 * rig.creepage();
    problem.speed = speed;
    problem.heat = unlike;
    const auto found = rolling::steady_rolling(*rig.row_grid(), problem);
    const double slip = 200 * rig.creepage() * speed;
    const double q = rig.friction * found.state.peak_pressure * slip;
    double highest = 0;
    for (double x = -1; x <= 1; x += 1e-4) highest = std::max(highest, theory::elliptic_heating(x));
    const double expected =
        q / flux * std::sqrt(rig.half_length / half_length) * unit(unlike) * highest;
    ASSERT_TRUE(found.state.temperature);
    // Strains are 1/200 of the slip, and change it about the middle.
    EXPECT_NEAR(found.state.temperature->friction_rise / expected, 1, 5e-3);
    EXPECT_NEAR(found.state.temperature->value, found.state.temperature->friction_rise, 1e-9);
    EXPECT_EQ(found.temperatures->indenter.size(), found.surface.size());
    problem.heat.reset();
    EXPECT_FALSE(rolling::steady_rolling(*rig.row_grid(), problem).state.temperature);
}

}  // namespace
}  // namespace tricontact::rolling_temperatures_test
