// Periodic layers against uniform and sinusoidal loads, sums over images, and one indenter alone.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <random>
#include <string>

#include "bem/influence.h"
#include "bem/model.h"
#include "bem/periodic_compliance.h"
#include "bem/settings.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"

namespace tricontact::periodic_test {
namespace {

using bem::Body;
using bem::PeriodicCompliance;
using bem::PeriodicInfluence;
using contact::Case;
using contact::ContactPoints;
using contact::Material;
using contact::NormalControl;
using contact::TangentialField;
using theory::LayerBase;
using theory::LayerStack;

constexpr double pi = std::numbers::pi;

ContactPoints period_grid(double period, int n) {
    const double h = period / n, first = -(n / 2) * h;
    return ContactPoints::grid(n, n, {first, first}, {h, h});
}

LayerStack layer(double nu, double b = 1) {
    return {{{{2.3, nu}, b}}, LayerBase::bonded, {}};
}

// All six coefficients of a cell at (i, j) from the Fourier ones.
std::array<double, 6> at_cell(const PeriodicInfluence& influence, int n, int i, int j) {
    std::array<std::complex<double>, 6> sum{};
    const std::complex<double> one(0, 1);
    for (int m_x = -(n - 1) / 2; m_x <= n / 2; ++m_x)
        for (int m_y = -(n - 1) / 2; m_y <= n / 2; ++m_y) {
            const auto k = influence.at(m_x, m_y);
            const auto wave =
                std::exp(one * (2 * pi * (m_x * i + m_y * j) / n)) / static_cast<double>(n * n);
            const std::array<std::complex<double>, 6> all{k.zz, k.xx,       k.xy,
                                                          k.yy, one * k.xz, one * k.yz};
            for (std::size_t c = 0; c < 6; ++c) sum[c] += all[c] * wave;
        }
    std::array<double, 6> real{};
    for (std::size_t c = 0; c < 6; ++c) real[c] = sum[c].real();
    return real;
}

// Another road: one cell's coefficients, added up over its images, which a bonded layer hardly
// feels beyond some thicknesses.
TEST(BemPeriodic, IsTheSumOverImages) {
    for (const auto& stack :
         {layer(.3), layer(.5), LayerStack{{{{2.3, .5}, 1}, {{8, .2}, .5}}, LayerBase::bonded, {}}})
        for (const int n : {15, 20}) {  // cells of 0.2 and 0.15 thicknesses
            const double period = 3, h = period / n;
            const PeriodicInfluence influence(stack, h, n, 1);
            const bem::LayerInfluence one(stack, {}, h, h, 32);
            const double own = one.at(0, 0).zz;
            for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {-2, 3}, {7, 5}, {5, -7}}) {
                bem::InfluenceCoefficients sum{};
                for (int p = -6; p <= 6; ++p)
                    for (int q = -6; q <= 6; ++q) {
                        const auto k = one.at(i * h + p * period, j * h + q * period);
                        sum.zz += k.zz, sum.xx += k.xx, sum.xy += k.xy;
                        sum.yy += k.yy, sum.xz += k.xz, sum.yz += k.yz;
                    }
                const auto found = at_cell(influence, n, i, j);
                const std::array expected{sum.zz, sum.xx, sum.xy, sum.yy, sum.xz, sum.yz};
                for (std::size_t c = 0; c < 6; ++c)  // images beyond 18 b; aliases end at 1e-7
                    EXPECT_NEAR(found[c] / own, expected[c] / own, 2e-6)
                        << "n " << n << ", cell " << i << ' ' << j << ", component " << c;
            }
        }
}

// The oedometer, b (1 - 2 nu)/(2 G (1 - nu)), and simple shear, b/G, of each layer.
TEST(BemPeriodic, UniformLoad) {
    for (const double nu : {-.4, .3, .5}) {
        const Material top{2.3, nu}, below{8, .2};
        const PeriodicCompliance compliance({{{top, 1}, {below, .5}}, LayerBase::bonded, {}},
                                            period_grid(4, 12), 1);
        const std::size_t n = compliance.points().size();
        std::vector<double> p(n, 3), u_z(n);
        TangentialField t(n), u(n);
        std::fill(t.x.begin(), t.x.end(), 2);
        std::fill(t.y.begin(), t.y.end(), -1);
        compliance.normal(p, u_z);
        compliance.tangential(t, u);
        const double g = top.shear_modulus(), g2 = below.shear_modulus();
        const double normal = 3 * ((1 - 2 * nu) / (2 * g * (1 - nu)) + .5 * .6 / (2 * g2 * .8));
        for (const double value : u_z) EXPECT_NEAR(value / normal, 1, 1e-12);
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_NEAR(u.x[i] / (2 * (1 / g + .5 / g2)), 1, 1e-12);
            EXPECT_NEAR(u.y[i] / -(1 / g + .5 / g2), 1, 1e-12);
        }
        compliance.tangential_from_normal(p, u);
        for (const double value : u.x) EXPECT_NEAR(value * g, 0, 1e-12);
    }
    const PeriodicCompliance incompressible(layer(.5), period_grid(4, 12), 1);
    std::vector<double> p(144, 1), u_z(144);
    incompressible.normal(p, u_z);
    for (const double value : u_z) EXPECT_NEAR(value * 2.3, 0, 1e-13);
}

// A wave of pressure displaces by C33, and sideways by C13, a quarter of a period behind; tractions
// along and across it by C11 and C22. Cells are uniform: O(h^2).
TEST(BemPeriodic, SinusoidalLoadTakesTheLayersCompliance) {
    const double period = 2.5;
    for (const double nu : {.3, .5}) {
        const auto stack = layer(nu);
        const double k = 2 * pi / period * 2;
        const auto exact = theory::surface_compliance(stack, k);
        const auto errors = [&](int n) {
            const PeriodicCompliance compliance(stack, period_grid(period, n), 1);
            const auto& points = compliance.points();
            std::vector<double> p, sine, u_z(points.size());
            for (const double x : points.x) p.push_back(std::cos(k * x));
            for (const double x : points.x) sine.push_back(std::sin(k * x));
            const auto amplitude = [&](const std::vector<double>& u, const std::vector<double>& w) {
                return std::inner_product(u.begin(), u.end(), w.begin(), 0.) * 2 /
                       static_cast<double>(points.size());
            };
            TangentialField t(points.size()), u(points.size());
            compliance.normal(p, u_z);
            const double normal = amplitude(u_z, p);
            compliance.tangential_from_normal(p, u);
            const double coupling = -amplitude(u.x, sine);  // i C13 cos: - C13 sin
            t.x = t.y = p;
            compliance.tangential(t, u);
            const double unit = exact.normal;
            return std::array{(normal - exact.normal) / unit, (coupling - exact.coupling) / unit,
                              (amplitude(u.x, p) - exact.along) / unit,
                              (amplitude(u.y, p) - exact.across) / unit};
        };
        const auto coarse = errors(32), middle = errors(64), fine = errors(129);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(std::log2(coarse[c] / middle[c]), 2, .15) << "nu " << nu << ' ' << c;
            EXPECT_NEAR(std::log(middle[c] / fine[c]) / std::log(129. / 64), 2, .15)
                << "nu " << nu << ' ' << c;
            EXPECT_LT(std::abs(fine[c]), 3e-3) << "nu " << nu << ' ' << c;
        }
    }
}

// Westergaard (1939), Johnson (1985), sec. 13.2: a rigid wave of amplitude A on a half-space, which
// a layer five wavelengths thick is: p* = pi E* A/lambda; full contact from a mean pressure of p*
// on, p = mean + p* cos; below, strips of the half width a, mean = p* sin^2(pi a/lambda).
TEST(BemPeriodic, WestergaardsWave) {
    const double lambda = 1.5, amplitude = 1e-3, nu = .3;
    const int n = 63;
    const auto stack = layer(nu, 5 * lambda);
    const double e_star = 2.3 / (1 - nu * nu), full = pi * e_star * amplitude / lambda;
    const PeriodicCompliance compliance(stack, period_grid(lambda, n), 1);
    const auto& points = compliance.points();
    std::vector<double> height;
    for (const double x : points.x)
        height.push_back(amplitude * (1 - std::cos(2 * pi * x / lambda)));
    const auto pressed = [&](double mean) {
        return contact::NormalSolver(compliance, 1e-9)
            .solve(height, {NormalControl::Kind::force, mean * lambda * lambda})
            .pressure;
    };
    const auto all = pressed(1.7 * full);
    for (std::size_t i = 0; i < all.size(); ++i)  // O(h^2): (k h)^2/24
        EXPECT_NEAR(all[i] / full, 1.7 + std::cos(2 * pi * points.x[i] / lambda), 2e-3);
    for (const double a : {.1, .25, .4}) {
        const auto strip = pressed(full * std::pow(std::sin(pi * a), 2));
        const auto n_loaded =
            std::count_if(strip.begin(), strip.end(), [](double p) { return p > 0; });
        // Whole rows of cells: half of one on either side.
        EXPECT_NEAR(static_cast<double>(n_loaded) / n / n, 2 * a, 1.01 / n) << a;
    }
}

TEST(BemPeriodic, IsSelfAdjointAndPositive) {
    const PeriodicCompliance compliance(layer(.5), period_grid(3, 14), 1);
    const std::size_t n = compliance.points().size();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto noise = [&] {
        std::vector<double> values(n);
        for (double& value : values) value = uniform(random);
        return values;
    };
    const auto dot = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    };
    const auto p = noise(), q = noise();
    TangentialField t(n), s(n), u(n), v(n);
    t.x = noise(), t.y = noise(), s.x = noise(), s.y = noise();
    std::vector<double> a(n), b(n);
    compliance.normal(p, a);
    compliance.normal(q, b);
    EXPECT_NEAR(dot(q, a) / dot(p, b), 1, 1e-12);
    EXPECT_GT(dot(p, a), 0);
    compliance.tangential(t, u);
    compliance.tangential(s, v);
    EXPECT_NEAR((dot(s.x, u.x) + dot(s.y, u.y)) / (dot(t.x, v.x) + dot(t.y, v.y)), 1, 1e-12);
    EXPECT_GT(dot(t.x, u.x) + dot(t.y, u.y), 0);
    compliance.tangential_from_normal(p, u);
    compliance.normal_from_tangential(t, a);
    EXPECT_NEAR(dot(t.x, u.x) + dot(t.y, u.y), dot(p, a), 1e-12 * dot(t.x, t.x));
    // The exact inverse, whose scale is free.
    compliance.tangential(t, u);
    compliance.precondition_tangential(u, v);
    const double scale = v.x[0] / t.x[0];
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(v.y[i] / scale, t.y[i], 1e-10);
}

Case pressed_case() {
    Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {5.2e6, .5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = .57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = .5;
    c.of<contact::Cells>().spacing = .5e-3;
    return c;
}

contact::Scales pressed(const Case& c) {
    const auto model = bem::make_model(c, 1, Body::layer);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model->advance(step);
    return model->scales();
}

// Where the determinant of a bonded layer's compliance vanishes, k = i y/b with the least y:
// 2 kappa cos 2y - 4 y^2 + 1 + kappa^2 = 0; at nu = 1/2, cos y = y.
double slowest_decay(double nu) {
    const double kappa = 3 - 4 * nu;
    double y = 1;
    for (int i = 0; i < 50; ++i)
        y += (2 * kappa * std::cos(2 * y) - 4 * y * y + 1 + kappa * kappa) /
             (4 * kappa * std::sin(2 * y) + 8 * y);
    return y;
}

// The four nearest neighbours are felt as exp(-y L/b)/sqrt(L/b): waves that decay across the layer.
TEST(BemPeriodic, NeighboursFadeExponentially) {
    const double b = 8e-3, near = 12, far = 16;  // periods over b
    EXPECT_NEAR(slowest_decay(.5), .7390851332, 1e-9);
    for (const double nu : {.3, .5}) {
        Case c = pressed_case();
        c.substrate.poisson = nu;
        c.of<bem::Settings>().tolerance = 1e-11;
        const auto alone = pressed(c);
        const auto with_neighbours = [&](double period) {
            c.period = period * b;
            return pressed(c);
        };
        const auto one = with_neighbours(near), other = with_neighbours(far);
        const double expected = slowest_decay(nu) * (far - near) + std::log(far / near) / 2;
        const auto decay = [&](double contact::Scales::*value) {
            return std::log((one.*value / alone.*value - 1) / (other.*value / alone.*value - 1));
        };
        // The next order of the waves is b/L of it; solved to 1e-12 of d, of which 5e-9 is left.
        EXPECT_NEAR(decay(&contact::Scales::indentation) / expected, 1, .01) << nu;
        EXPECT_NEAR(decay(&contact::Scales::unit_shift) / expected, 1, .03) << nu;
        EXPECT_LT(std::abs(other.indentation / alone.indentation - 1), 1e-6) << nu;
    }
}

std::string message(const Case& c, Body body = Body::layer) {
    try {
        bem::make_model(c, 1, body);
    } catch (const contact::InputError& error) {
        return error.what();
    }
    return "no error";
}

// Cells fill the period, but only those of the contact are in the grid.
TEST(BemPeriodic, SpacingDividesThePeriod) {
    Case c = pressed_case();
    c.period = 40.5e-3;
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = 9;
    const auto model = bem::make_model(c, 1, Body::layer);
    model->advance(contact::press_step(c));
    const auto s = model->surface();
    const double cells = 40.5e-3 / s.spacing[0];
    EXPECT_NEAR(cells, std::round(cells), 1e-9);
    EXPECT_LE(s.spacing[0], contact::half_space_scales(c).contact_radius / 9);
    EXPECT_LT(s.n_x * s.spacing[0], 20e-3);
}

// The cells of the contact with their periodic influence are the whole period's, whose other cells
// carry nothing.
TEST(BemPeriodic, CellsOfTheContactStandForThePeriod) {
    for (const double period : {14e-3, 14.5e-3, 24e-3}) {
        Case c = pressed_case();
        c.period = period;
        c.of<bem::Settings>().tolerance = 1e-10;
        const auto part = pressed(c);
        const auto n = static_cast<int>(std::round(period / *c.of<contact::Cells>().spacing));
        const PeriodicCompliance whole({{{c.substrate, 8e-3}}, LayerBase::bonded, {}},
                                       period_grid(period, n), 1);
        const auto height = contact::heights_over(whole.points(), *c.make_indenter(), {0, 0});
        const auto pressure =
            contact::NormalSolver(whole, 1e-11).solve(height, {NormalControl::Kind::force, 21.1});
        EXPECT_NEAR(pressure.indentation / part.indentation, 1, 1e-9) << period;
        EXPECT_NEAR(*std::max_element(pressure.pressure.begin(), pressure.pressure.end()) /
                        part.peak_pressure,
                    1, 1e-8)
            << period;
    }
}

TEST(BemPeriodic, RefusesWhatHasNoMeanOrNoRoom) {
    Case c = pressed_case();
    c.period = 40e-3;
    EXPECT_EQ(message(c), "no error");
    EXPECT_EQ(message(c, Body::half_space),
              "bem: under a periodic load the half-space gives way without bound, its compliance "
              "at k = 0 is infinite; take bem-layer or omit bem.period");
    Case other = c;
    other.layer.base = Case::Base::frictionless;
    EXPECT_EQ(message(other),
              "bem-layer: nothing holds periodic layers on a frictionless base, their tangential "
              "compliance at k = 0 is infinite; take base = \"bonded\" or omit bem.period");
    other = c;
    other.layer.base = Case::Base::half_space;
    other.layer.ground = Material{1e9, .3};
    EXPECT_EQ(message(other),
              "bem-layer: under a periodic load an elastic half-space gives way without bound, its "
              "compliance at k = 0 is infinite; take base = \"bonded\" or omit bem.period");
    other = c;
    other.period = 40.2e-3;
    EXPECT_EQ(message(other),
              "bem: a period of 0.0402 m is no whole number of cells of 0.0005 m; take a spacing "
              "of 0.0005025 m");
    // Incompressible or not, pressed until neighbours meet.
    for (const double nu : {.3, .5}) {
        other = c;
        other.substrate.poisson = nu;
        other.period = 10e-3;
        other.load.normal_force = 2000;
        EXPECT_EQ(message(other),
                  "bem-layer: contact and rolling path reach the edge of the period of 0.01 m, "
                  "neighbouring contacts would merge; enlarge bem.period or reduce the load")
            << nu;
    }
    try {
        bem::case_influence(c, 1, Body::layer);
        FAIL();
    } catch (const contact::InputError& error) {
        EXPECT_NE(std::string(error.what()).find("has no influence coefficients"),
                  std::string::npos);
    }
}

}  // namespace
}  // namespace tricontact::periodic_test
