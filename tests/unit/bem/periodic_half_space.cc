// The half-space under periodic tractions, displacements from its mean plane.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>

#include "bem/grid_compliance.h"
#include "bem/influence.h"
#include "bem/periodic_compliance.h"
#include "contact/base/error.h"
#include "contact/bodies/height_map.h"
#include "contact/bodies/roughness.h"
#include "contact/friction/friction.h"
#include "contact/solvers/contact_region.h"
#include "contact/solvers/normal_solver.h"
#include "contact/surface_model.h"

namespace tricontact::periodic_half_space_test {
namespace {

using bem::PeriodicCompliance;
using contact::ContactPoints;
using contact::Material;
using contact::MaterialPair;
using contact::NormalControl;
using contact::TangentialField;

constexpr double pi = std::numbers::pi;

ContactPoints period_grid(double period, int n) {
    const double h = period / n, first = -(n / 2) * h;
    return ContactPoints::grid(n, n, {first, first}, {h, h});
}

/// Amplitude of a wave in a field.
double amplitude(const std::vector<double>& u, const std::vector<double>& wave) {
    return std::inner_product(u.begin(), u.end(), wave.begin(), 0.) * 2 /
           static_cast<double>(u.size());
}

// Johnson (1985), sec. 13.2: p cos kx displaces by 2 p/(E* k), a traction along the wave by as much
// on an incompressible half-space and across it by 1/(G k). Uniform cells: O(h^2).
TEST(BemPeriodicHalfSpace, SinusoidalLoads) {
    const double period = 2.5, k = 2 * pi / period * 2;
    const Material rubber{2.3, .3}, steel{7, .25};
    for (const MaterialPair& pair :
         {MaterialPair{std::nullopt, rubber}, MaterialPair{steel, rubber}}) {
        const auto errors = [&](int n) {
            const PeriodicCompliance compliance(pair, period_grid(period, n), 1);
            const auto& points = compliance.points();
            std::vector<double> p, sine, u_z(points.size());
            for (const double x : points.x) p.push_back(std::cos(k * x));
            for (const double x : points.x) sine.push_back(std::sin(k * x));
            TangentialField t(points.size()), u(points.size());
            compliance.normal(p, u_z);
            t.x = t.y = p;
            compliance.tangential(t, u);
            const double unit = 2 / (pair.effective_modulus() * k);
            const double across = (pair.one_minus_nu_over_g() + pair.nu_over_g()) / k;
            std::array<double, 4> error{amplitude(u_z, p) / unit - 1, amplitude(u.x, p) / unit - 1,
                                        amplitude(u.y, p) / across - 1, 0};
            compliance.tangential_from_normal(p, u);  // i C13 cos: - C13 sin
            const double coupling = pair.one_minus_two_nu_over_g() / 2 / k;
            error[3] = -amplitude(u.x, sine) / coupling - 1;
            return error;
        };
        const auto coarse = errors(32), middle = errors(64), fine = errors(129);
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_NEAR(std::log2(coarse[c] / middle[c]), 2, .15) << c;
            EXPECT_NEAR(std::log(middle[c] / fine[c]) / std::log(129. / 64), 2, .15) << c;
            EXPECT_LT(std::abs(fine[c]), 3e-3) << c;
        }
    }
}

// Single cells of both signs, far fewer than a period apart: Love's and Cerruti's rectangles and
// their images. The sum over images of a pair converges as 1/distance.
TEST(BemPeriodicHalfSpace, IsTheSumOverImages) {
    const MaterialPair pair{{}, Material{2.3, .3}};
    const int n = 15, images = 40;
    const double period = 3, h = period / n;
    const PeriodicCompliance compliance(pair, period_grid(period, n), 1);
    const bem::RectangleInfluence one(pair, h, h);
    std::vector<double> p(n * n), u(n * n);
    const int centre = n / 2 * n + n / 2;
    // four cells whose monopole, dipole vanish
    p[centre] = p[centre + 1 + n] = 1;
    p[centre + 1] = p[centre + n] = -1;
    compliance.normal(p, u);
    const auto& points = compliance.points();
    for (const int at : {centre, centre + 3, 2 * n + 1, 14 * n + 9}) {
        double sum = 0;
        for (int a = -images; a <= images; ++a)
            for (int b = -images; b <= images; ++b)
                for (int i = 0; i < n * n; ++i)
                    if (p[i] != 0)
                        sum += p[i] * one.at(points.x[at] - points.x[i] + a * period,
                                             points.y[at] - points.y[i] + b * period)
                                          .zz;
        // aliases end at 1e-7, images at (h/period)^2/images^2
        EXPECT_NEAR(u[at] / one.at(0, 0).zz, sum / one.at(0, 0).zz, 3e-6) << at;
    }
}

// Westergaard (1939), Johnson (1985), sec. 13.2: a rigid wave A cos kx, p* = pi E* A/lambda; full
// contact from a mean pressure of p* on, p = mean + p* cos; below, strips of the half width a,
// mean = p* sin^2(pi a/lambda).
TEST(BemPeriodicHalfSpace, WestergaardsWave) {
    const double lambda = 1.5, wave = 1e-3;
    const int n = 63;
    const MaterialPair pair{{}, Material{2.3, .3}};
    const double full = pi * pair.effective_modulus() * wave / lambda;
    const PeriodicCompliance compliance(pair, period_grid(lambda, n), 1);
    const auto& points = compliance.points();
    std::vector<double> height;
    for (const double x : points.x) height.push_back(wave * (1 - std::cos(2 * pi * x / lambda)));
    const auto pressed = [&](double mean) {
        return contact::NormalSolver(compliance, 1e-9)
            .solve(height, {NormalControl::Kind::force, mean * lambda * lambda});
    };
    const auto all = pressed(1.7 * full);
    for (std::size_t i = 0; i < all.pressure.size(); ++i)  // O(h^2): (k h)^2/24
        EXPECT_NEAR(all.pressure[i] / full, 1.7 + std::cos(2 * pi * points.x[i] / lambda), 2e-3);
    // The mean plane lies at the wave's mean height.
    EXPECT_NEAR(all.indentation / wave, 1, 1e-9);
    for (const double a : {.1, .25, .4}) {
        const auto strip = pressed(full * std::pow(std::sin(pi * a), 2));
        const auto n_loaded = std::count_if(strip.pressure.begin(), strip.pressure.end(),
                                            [](double p) { return p > 0; });
        // Whole rows of cells: half of one on either side.
        EXPECT_NEAR(static_cast<double>(n_loaded) / n / n, 2 * a, 1.01 / n) << a;
        const auto u = std::accumulate(strip.displacement.begin(), strip.displacement.end(), 0.);
        EXPECT_NEAR(u / n / n / wave, 0, 1e-12) << a;  // by definition
        // The same indentation prescribed brings the same force back.
        const auto again =
            contact::NormalSolver(compliance, 1e-9)
                .solve(height, {NormalControl::Kind::indentation, strip.indentation});
        EXPECT_NEAR(again.force / strip.force, 1, 1e-6) << a;
    }
}

/// A rough plane over 64 x 64 cells.
struct Rough {
    contact::Roughness surface{.hurst = .8,
                               .rms_slope = .1,
                               .long_wavelength = 1e-3,
                               .roll_off = .5e-3,
                               .short_wavelength = 1e-3 / 8,
                               .seed = 1};
    std::shared_ptr<const contact::Indenter> indenter = std::make_shared<contact::RoughIndenter>(
        std::make_unique<contact::Plane>(), make_roughness(surface, 64));
};

contact::LoadStep pressed(double normal_force, double tangential_force) {
    contact::LoadStep step;
    step.normal = {NormalControl::Kind::force, normal_force};
    step.tangential[0].value = tangential_force;
    return step;
}

// Ciavarella (1998), Jaeger (1998): where tangential and normal compliance are alike (nu = 0, their
// coupling left out) t = mu (p - p'), p' the pressure at F_N - F_T/mu, whatever the surface; so the
// shift is mu (E*/G*) (d - d').
TEST(BemPeriodicHalfSpace, MicroSlipOfARoughPlaneIsThatOfItsPressures) {
    const Rough rough;
    const MaterialPair pair{{}, Material{10e6, 0}};
    const double mu = .4, area = 1e-6, force = .05 * pair.effective_modulus() * .1 * area;
    const auto compliance = std::make_shared<PeriodicCompliance>(pair, period_grid(1e-3, 64), 1);
    contact::SurfaceModel model("bem", compliance, rough.indenter, contact::Friction{mu}.law(),
                                1e-8, {.coupling = false});
    contact::LoadStep press = pressed(force, 0);
    press.friction = false;
    const double depth = model.advance(press).indentation;
    const auto full = model.surface().normal_traction;
    for (const double ratio : {.2, .5, .8, .95}) {
        const auto record = model.advance(pressed(force, ratio * mu * force));
        const auto surface = model.surface();
        contact::SurfaceModel less("bem", compliance, rough.indenter, contact::Friction{mu}.law(),
                                   1e-8, {.coupling = false});
        contact::LoadStep lighter = pressed((1 - ratio) * force, 0);
        lighter.friction = false;
        const double shallow = less.advance(lighter).indentation;
        const auto rest = less.surface().normal_traction;
        const double alike = pair.effective_modulus() / pair.effective_shear_modulus();
        EXPECT_NEAR(record.shift[0] / (mu * alike * (depth - shallow)), 1, 1e-6) << ratio;
        const double peak = *std::max_element(full.begin(), full.end());
        for (std::size_t i = 0; i < full.size(); ++i)
            EXPECT_NEAR(surface.tangential_traction_x[i] / (mu * peak), (full[i] - rest[i]) / peak,
                        1e-5);
    }
}

// Nothing is pressed into a period whose whole surface already lies at the indenter.
TEST(BemPeriodicHalfSpace, HoldsInFullContactTangentially) {
    const MaterialPair pair{{}, Material{10e6, .5}};
    const auto compliance = std::make_shared<PeriodicCompliance>(pair, period_grid(1e-3, 16), 1);
    const double wave = 1e-6;
    contact::HeightMap map{16, 16, {1e-3 / 16, 1e-3 / 16}, {}};
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i) map.height.push_back(wave * std::cos(2 * pi * i / 16.));
    const double full = pi * pair.effective_modulus() * wave / 1e-3, force = 2 * full * 1e-6;
    contact::SurfaceModel model(
        "bem", compliance,
        std::make_shared<contact::RoughIndenter>(std::make_unique<contact::Plane>(), map),
        contact::Friction{.4}.law(), 1e-7);
    contact::LoadStep press = pressed(force, 0);
    press.friction = false;
    model.advance(press);
    const auto record = model.advance(pressed(force, .3 * .4 * force));
    // All stick under a uniform traction: it moves nothing against the mean plane.
    EXPECT_NEAR(record.stick_area / 1e-6, 1, 1e-12);
    EXPECT_NEAR(record.shift[0] / wave, 0, 1e-6);
}

}  // namespace
}  // namespace tricontact::periodic_half_space_test
