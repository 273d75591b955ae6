// Plane strain beside closed forms: Hertz, a cylinder between plates, a pin in a hole, a rounded
// punch, a layer that recedes.

#include <gtest/gtest.h>

#include <numbers>

#include "tests/unit/fem/planar/two_bodies.h"

namespace tricontact::line_contacts_test {
namespace {

using namespace planar_test;
using std::numbers::pi;
using Kind = contact::NormalControl::Kind;

PairOptions halves() {
    PairOptions options;
    options.halves = true;
    return options;
}

std::vector<double> parabola(const ContactGrid& grid, double radius) {
    std::vector<double> height;
    for (const double x : grid.along) height.push_back(x * x / (2 * radius));
    return height;
}

double between(const Pressed& pressed, double x) {
    const auto above = std::ranges::upper_bound(pressed.along, x);
    const std::size_t i = above - pressed.along.begin() - 1;
    const double w = (x - pressed.along[i]) / (pressed.along[i + 1] - pressed.along[i]);
    return (1 - w) * pressed.pressure[i] + w * pressed.pressure[i + 1];
}

/// Last point with pressure.
double last_touching(const Pressed& pressed) {
    std::size_t i = 0;
    while (pressed.pressure[i] > 0) ++i;
    return pressed.along[i - 1];
}

// Two bodies of E = 2, nu = .3, R = 100 a: a half-space to (a/R)^2. Root mean square of p - p_Hertz
// at the same force, over p0, within .8 a; `finer`: size of the block's elements over the disc's.
double error_of_pressures(const Sizes& sizes, double finer) {
    const double radius = 100, modulus = 2 / (1 - .09) / 2, force = pi * modulus / (4 * radius);
    const double peak = 2 * force / pi;
    Sizes of_block = sizes;
    of_block.size *= finer;
    of_block.n = static_cast<int>(std::ceil(sizes.n / finer));
    const std::vector<CondensedSection> bodies{
        body_of(half_disc_section(sizes, radius), Solid::plane_strain, {2, .3}),
        body_of(layer_section(of_block, 600, 600), Solid::plane_strain, {2, .3})};
    const ContactGrid grid = grid_between(bodies);
    const Pressed pressed =
        press(bodies, grid, halves(), parabola(grid, radius), {Kind::force, force});
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < grid.size() && grid.along[i] < .8; ++i, ++n) {
        const double exact = peak * std::sqrt(1 - grid.along[i] * grid.along[i]);
        sum += std::pow((pressed.pressure[i] - exact) / peak, 2);
    }
    return std::sqrt(sum / n);
}

// The edge of the contact is a node of the disc on all meshes: 6, 12, 24 elements across it. Forces
// over tributary areas are means of the pressure, which the root at the edge spoils nearby; the
// consistent pressures of a mortar are of second order.
TEST(FemPlanarLineContacts, PressuresOfTwoCylindersConverge) {
    for (const double finer : {1., .7}) {
        std::vector<double> error;
        Sizes sizes{8, 1. / 6, 1.3, 4};
        for (int k = 0; k < 3; ++k, sizes = sizes.halved())
            error.push_back(error_of_pressures(sizes, finer));
        EXPECT_GT(std::log2(error[0] / error[2]) / 2, finer < 1 ? 2 : 1.5) << finer;
        EXPECT_LT(error[2], 3e-4) << finer;
    }
}

// Johnson (1985), eq. 5.57 with one direction of pressing: 2 ln(4R/a) - 1 over pi, the approach
// of one plate. The arc is no parabola: (a/R)^2/10.
TEST(FemPlanarLineContacts, CylinderBetweenPlates) {
    for (const double poisson : {.3, .495})
        for (const double a : {.5, 1.}) {
            const double radius = 10, modulus = 2 / (1 - poisson * poisson);
            const double force = pi * modulus * a * a / (4 * radius);
            const auto body = body_of(half_disc_section({32, 1.3 * a / 32, 1.25, 5}, radius),
                                      Solid::plane_strain, {2, poisson}, Support::sliding);
            const ContactGrid grid = points_on_nodes({body});
            const Pressed pressed =
                press({body}, grid, halves(), parabola(grid, radius), {Kind::force, force});
            const double exact = (2 * std::log(4 * radius / a) - 1) / pi;
            EXPECT_NEAR(pressed.indentation * modulus / force / exact, 1, a < 1 ? 3e-4 : 1e-3);
            EXPECT_NEAR(pressed.radius / a, 1, 3e-3);
            EXPECT_NEAR(pressed.peak * pi * a / (2 * force), 1, 3e-3);
        }
}

// The same disc under the pressure of Hertz along its radii, which couples: half the approach from
// the disc's own Green's function. Linear: 1e-4.
TEST(FemPlanarLineContacts, DiscUnderRadialPressures) {
    struct Case {
        double poisson, a, approach;
    };
    for (const Case& c : {Case{.3, .5, 2.47658}, Case{.495, .5, 2.47073}, Case{.3, 1, 2.03935},
                          Case{.495, 1, 2.02766}}) {
        const double radius = 10, modulus = 2 / (1 - c.poisson * c.poisson);
        const auto body =
            body_of(half_disc_section({64, 1.3 * c.a / 64, 1.25, 10}, radius), Solid::plane_strain,
                    {2, c.poisson}, Support::sliding, Frame::round, radius);
        const ContactGrid grid = points_on_nodes({body});
        const auto pair = pair_compliance({body}, grid, halves());
        std::vector<double> p(grid.size()), u(grid.size());
        for (std::size_t i = 0; i < p.size(); ++i)
            p[i] = std::sqrt(std::max(0., 1 - std::pow(grid.along[i] / c.a, 2)));
        pair->normal(p, u);
        const double force = pi * c.a / 2;  // per p0
        EXPECT_NEAR(u[0] * modulus / force / c.approach, 1, 1e-4);
    }
}

// Persson (1964), Ciavarella and Decuzzi (2001): E1* DR/Q and R p_max/Q at the half angle. The pin
// is held by a hub of R/50, the plate ends at 100 R: 4e-4 and 1e-4.
TEST(FemPlanarLineContacts, PinInAHole) {
    struct Case {
        double angle, clearance, peak, pin, hole;  // E of both; 0: rigid
        double poisson;
    };
    for (const Case& c :
         {Case{10, 82.2206, 3.66156, 2, 2, .3}, Case{30, 7.94354, 1.260289, 2, 2, .3},
          Case{60, 1.067202, .711721, 2, 2, .3}, Case{30, 4.24231, 1.25154, 0, 2, .3},
          Case{60, .533915, .705526, 0, 2, .3}, Case{30, 6.0323, 1.26029, 2, 4, .495}}) {
        const double angle = c.angle * pi / 180, force = 1e-3;
        const double young = c.pin > 0 ? c.pin : c.hole;
        const double clearance = c.clearance * force * (1 - c.poisson * c.poisson) / young;
        const Sizes sizes{32, 1.3 * angle / 32, 1.25, 5};
        std::vector<CondensedSection> bodies{body_of(hole_section(sizes, 1, 100),
                                                     Solid::plane_strain, {c.hole, c.poisson},
                                                     Support::bonded, Frame::round, 1)};
        if (c.pin > 0)
            bodies.push_back(body_of(pin_section(sizes, 1, .02), Solid::plane_strain,
                                     {c.pin, c.poisson}, Support::bonded, Frame::round, 1));
        const ContactGrid grid = grid_between(bodies);
        PairOptions options = halves();
        options.conforming = true;
        options.radius = 1;
        std::vector<double> height;
        for (const double s : grid.along)
            height.push_back(clearance * (1 - std::cos(s)) / std::cos(s));
        const Pressed pressed = press(bodies, grid, options, height, {Kind::force, force});
        EXPECT_NEAR(pressed.peak / force / c.peak, 1, 1e-3) << c.angle << ' ' << c.pin;
        EXPECT_NEAR(last_touching(pressed), angle, 1.5 * sizes.size / 2) << c.angle << ' ' << c.pin;
    }
}

// Ciavarella, Hills and Monno (1998): half the flat part is half the contact. 3e-4 of the mean
// pressure inside; beside the edge, where p falls as a root, three times that.
TEST(FemPlanarLineContacts, PunchWithRoundedEdges) {
    const double flat = .5, radius = 50, modulus = 2 / (1 - .09);
    const double force = .307092 * modulus / radius;
    const auto block =
        body_of(layer_section({48, 1.25 / 48, 1.2, 8}, 300, 300), Solid::plane_strain, {2, .3});
    const ContactGrid grid = points_on_nodes({block});
    std::vector<double> height;
    for (const double x : grid.along)
        height.push_back(std::pow(std::max(0., x - flat), 2) / (2 * radius));
    const Pressed pressed = press({block}, grid, halves(), height, {Kind::force, force});
    EXPECT_NEAR(between(pressed, 0) / force, .40292, 3e-4);
    EXPECT_NEAR(between(pressed, .3) / force, .44017, 3e-4);
    EXPECT_NEAR(between(pressed, .6) / force, .66610, 3e-4);
    EXPECT_NEAR(between(pressed, .95) / force, .33243, 1e-3);
}

// The same profile turned about its axis, on a block of 3000 contact radii: 3e-4 in F.
TEST(FemPlanarLineContacts, RoundedPunchOfRevolution) {
    const double radius = 50, modulus = 2 / (1 - .09);
    const contact::RoundedPunch punch(.5, radius);
    const auto block =
        body_of(layer_section({48, 1.25 / 48, 1.2, 8}, 3000, 3000), Solid::of_revolution, {2, .3});
    const Pressed pressed = press({block}, punch, .342427 / radius);
    EXPECT_NEAR(pressed.force * radius / modulus / .558933, 1, 6e-4);
    EXPECT_NEAR(last_touching(pressed), 1, 1.25 / 48);
}

// Keer, Dundurs and Tsai (1972), layer of thickness 1 under a line load, alpha = 0 and .5. The
// contact does not grow with the load; the layer is held along z at the load's point alone.
TEST(FemPlanarLineContacts, ALayerRecedes) {
    struct Case {
        double ratio, edge, peak;
    };
    for (const Case& c : {Case{1, 1.324165, .713080}, Case{3, 1.83630, .539451}}) {
        const Sizes sizes{60, .05, 1.25, 8};
        const std::vector<CondensedSection> bodies{
            body_of(block_section(sizes, 30, 1, [](double) { return 0.; }), Solid::plane_strain,
                    {2 * c.ratio, .3}, Support::point),
            body_of(layer_section(sizes, 300, 300), Solid::plane_strain, {2, .3})};
        const ContactGrid grid = grid_between(bodies);
        const std::vector<double> flat(grid.size(), 0);
        const Pressed once = press(bodies, grid, halves(), flat, {Kind::force, 1e-3});
        const Pressed twice = press(bodies, grid, halves(), flat, {Kind::force, 2e-3});
        // Second order: 6e-4 at 20 elements over the thickness.
        EXPECT_NEAR(once.peak / 1e-3 / c.peak, 1, 1e-3);
        EXPECT_NEAR(last_touching(once), c.edge, .025);
        EXPECT_EQ(last_touching(twice), last_touching(once));
        EXPECT_NEAR(twice.peak / once.peak, 2, 1e-8);
    }
}

}  // namespace
}  // namespace tricontact::line_contacts_test
