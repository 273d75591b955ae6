// A relaxing half-space under a rigid paraboloid, frictionless: Lee and Radok (1960) while the
// contact grows, Ting (1966) when it shrinks.

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/load_path.h"
#include "contact/relaxing_case.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem_viscoelastic_test {
namespace {

using contact::Case;
using contact::LoadStep;
using contact::NormalControl;
using contact::StepRecord;

constexpr double radius = .04, shear = 1.5e6, ratio = 1.7, tau = .3;

Case rubber(double cells_per_radius = 15) {
    Case c;
    c.indenter.radius = radius;
    c.substrate = {3 * shear, .5};
    c.relaxation = contact::Relaxation{{{ratio, tau}}, contact::Relaxation::Bulk::proportional};
    c.friction.coefficient = .5;
    c.load.indentation = 4e-4;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().per_radius = cells_per_radius;
    return c;
}

double relaxation(double t) {
    return shear * (1 + ratio * std::exp(-t / tau));
}
double creep(double t) {
    return (1 - ratio / (1 + ratio) * std::exp(-t / (tau * (1 + ratio)))) / shear;
}

LoadStep step(NormalControl::Kind kind, double value, double duration) {
    LoadStep s;
    s.normal = {kind, value};
    s.duration = duration;
    s.friction = false;
    return s;
}

// F = 16/3 sqrt(R) G d^(3/2) of the elastic incompressible half-space.
double hertz_force(double g, double d) {
    return 16. / 3 * std::sqrt(radius) * g * std::pow(d, 1.5);
}

/// Indentations while a force that is applied at once stays: d^(3/2) ~ F J(t).
struct Creep {
    double worst = 0;  ///< relative error
    double end = 0;    ///< d [m] after the last step
};
Creep creep_in(int n_steps) {
    const Case c = rubber();
    const auto model = bem::make_model(c, 1);
    const double force = hertz_force(shear, 3e-4), end = 3 * tau;
    Creep result;
    model->advance(step(NormalControl::Kind::force, force, 0));
    for (int k = 1; k <= n_steps; ++k) {
        result.end =
            model->advance(step(NormalControl::Kind::force, force, end / n_steps)).indentation;
        const double exact = 3e-4 * std::pow(creep(k * end / n_steps) * shear, 2. / 3);
        result.worst = std::max(result.worst, std::abs(result.end / exact - 1));
    }
    EXPECT_TRUE(model->audit().passed());
    return result;
}

TEST(BemViscoelastic, LeeAndRadokUnderConstantForce) {
    // 15 cells in a: 5e-4 of d without relaxation.
    EXPECT_LT(creep_in(24).worst, .001);
    // Second order in the step, on the same grid.
    const double coarse = creep_in(1).end, middle = creep_in(2).end, fine = creep_in(4).end;
    EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 2, .3);
}

/// d rises to `highest` at a constant rate, and falls again.
struct Triangle {
    double highest = 3e-4, turn = .5;
    double at(double t) const { return highest / turn * (t <= turn ? t : 2 * turn - t); }
    /// Lee and Radok; with an end before now Ting, who leaves out what has come after it.
    double force(double now, double end) const {
        const double rate = highest / turn;
        const auto integrand = [&](double s) {
            return relaxation(now - s) * 1.5 * std::sqrt(rate * s) * rate;
        };
        return 16. / 3 * std::sqrt(radius) *
               boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0., end, 15,
                                                                             1e-12);
    }
    /// When the contact was last as large as now: the surface it leaves has not moved since.
    double same_contact_before(double now) const {
        const auto g = [](double from, double to) {  // integral of G(s) over the age s
            return shear * (to - from) +
                   shear * ratio * tau * (std::exp(-from / tau) - std::exp(-to / tau));
        };
        const auto balance = [&](double t) { return g(now - turn, now - t) - g(0, now - turn); };
        boost::math::tools::eps_tolerance<double> tolerance(40);
        std::uintmax_t iterations = 100;
        const auto [low, high] =
            boost::math::tools::toms748_solve(balance, 0., turn, tolerance, iterations);
        return (low + high) / 2;
    }
};

TEST(BemViscoelastic, LeeAndRadokAndTing) {
    const Case c = rubber();
    const auto model = bem::make_model(c, 1);
    const Triangle path;
    const double peak = path.force(path.turn, path.turn);
    const int n = 60;
    double last_force = 1;
    for (int k = 1; k <= 2 * n - 1; ++k) {
        const double t = k * path.turn / n;
        const StepRecord r =
            model->advance(step(NormalControl::Kind::indentation, path.at(t), path.turn / n));
        if (k < n / 6) continue;  // few cells in contact yet
        if (k <= n) {
            EXPECT_NEAR(r.normal_force / path.force(t, t), 1, .005) << k;  // the cells
            continue;
        }
        // The contact is lost before the indenter is back.
        const auto since = [](double a) {
            return shear * a + shear * ratio * tau * (1 - std::exp(-a / tau));
        };
        if (since(t) - since(t - path.turn) <= since(t - path.turn)) {
            last_force = r.normal_force;
            break;
        }
        EXPECT_NEAR(r.normal_force / peak, path.force(t, path.same_contact_before(t)) / peak, .005)
            << k;
    }
    EXPECT_NEAR(last_force / peak, 0, .005);
    EXPECT_TRUE(model->audit().passed());
}

TEST(BemViscoelastic, HeldIndentationRelaxes) {
    const Case c = rubber();
    const auto model = bem::make_model(c, 1);
    const double at_once =
        model->advance(step(NormalControl::Kind::indentation, 3e-4, 0)).normal_force;
    double t = 0, stored = 0, dissipated = 0;
    for (const double duration : {.05, .1, .4, 1., 30.}) {
        t += duration;
        const auto r = model->advance(step(NormalControl::Kind::indentation, 3e-4, duration));
        // The contact stays as it is; the strain is constant: exact in any step.
        EXPECT_NEAR(r.normal_force / at_once, relaxation(t) / relaxation(0), 1e-6) << t;
        stored = r.stored_energy;
        dissipated += r.material_dissipation;
    }
    // The branch's spring has lost all it had: g of the relaxed spring's energy.
    EXPECT_NEAR(dissipated / stored, ratio, 1e-6);
    EXPECT_TRUE(model->audit().passed());
}

// No second spring, no dashpot, a dashpot that blocks; the latter two to their small parameter.
TEST(BemViscoelastic, ElasticLimits) {
    const auto force = [](const std::optional<contact::Relaxation>& relaxation, double young) {
        Case c = rubber(8);
        c.relaxation = relaxation;
        c.substrate.young = young;
        const auto model = bem::make_model(c, 1);
        double last = 0;
        for (int k = 1; k <= 5; ++k)
            last =
                model->advance(step(NormalControl::Kind::indentation, k * 6e-5, .1)).normal_force;
        return last;
    };
    const auto solid = [](double g, double t) {
        return contact::Relaxation{{{g, t}}, contact::Relaxation::Bulk::proportional};
    };
    const double relaxed = force({}, 3 * shear), glassy = force({}, 3 * shear * (1 + ratio));
    EXPECT_NEAR(force(solid(1e-9, tau), 3 * shear) / relaxed, 1, 1e-8);
    EXPECT_NEAR(force(solid(ratio, 1e-9), 3 * shear) / relaxed, 1, 1e-7);
    EXPECT_NEAR(force(solid(ratio, 1e9), 3 * shear) / glassy, 1, 1e-8);
}

/// A substrate whose bulk stays while its shear relaxes.
Case shear_alone(double cells_per_radius) {
    Case c = rubber(cells_per_radius);
    c.substrate = {2 * shear * 1.3, .3};
    c.relaxation->bulk = contact::Relaxation::Bulk::elastic;
    return c;
}

// Lee and Radok again: 1/E* = 1/(4 G) + 3/(4 (3 K + G)), the creep of a relaxing spring alone, and
// of one beside an elastic one. On the way Poisson's ratio goes from .05 to .3.
TEST(BemViscoelastic, LeeAndRadokWhereShearRelaxesAlone) {
    const double bulk = shear * 2 * 1.3 / (3 * (1 - .6)), force = hertz_force(shear, 3e-4);
    const auto creep = [&](double spring, double t) {
        const double relaxed = 1 / (1 + spring), glassy = 1 / (1 + ratio + spring);
        const double late = tau * (1 + spring + ratio) / (1 + spring);
        return relaxed - (relaxed - glassy) * std::exp(-t / late);
    };
    const auto exact = [&](double t) {
        const double soft = (creep(0, t) + 3 * creep(3 * bulk / shear, t)) / (4 * shear);
        return std::pow(3. / 4 * force * soft / std::sqrt(radius), 2. / 3);
    };
    const auto after = [&](int n_steps) {
        const auto model = bem::make_model(shear_alone(15), 1);
        const double end = 3 * tau;
        double d = 0;
        model->advance(step(NormalControl::Kind::force, force, 0));
        for (int k = 1; k <= n_steps; ++k) {
            d = model->advance(step(NormalControl::Kind::force, force, end / n_steps)).indentation;
            EXPECT_NEAR(d / exact(k * end / n_steps), 1, .001) << k;
        }
        EXPECT_TRUE(model->audit().passed());
        return d;
    };
    after(24);
    // Second order in the step, on the same grid; exact where the force grows linearly.
    const auto grown = [&](int n_steps, double power) {
        const auto model = bem::make_model(shear_alone(15), 1);
        double d = 0;
        for (int k = 1; k <= n_steps; ++k)
            d = model
                    ->advance(step(NormalControl::Kind::force,
                                   force * std::pow(1. * k / n_steps, power), 3 * tau / n_steps))
                    .indentation;
        return d;
    };
    EXPECT_NEAR(grown(2, 1) / grown(9, 1), 1, 1e-7);
    const double coarse = grown(4, 2), middle = grown(8, 2), fine = grown(16, 2);
    EXPECT_NEAR(std::log2((coarse - middle) / (middle - fine)), 2, .1);
}

// With friction, rolling, and normal and tangential contact coupled: the limits are elastic bodies
// whose layer has another shear modulus, and the same bulk modulus or ground. 3e-6 is the contact
// solvers' tolerance and the interpolation, over several steps.
TEST(BemViscoelastic, ElasticLimitsWhereAPartRelaxes) {
    Case c = shear_alone(8);
    c.of<contact::Cells>().spacing = 4e-4;
    c.of<contact::Cells>().per_radius.reset();
    c.layer.thickness = 4e-3;
    c.load.normal_force = 20;
    c.load.indentation.reset();
    c.load.tangential_force.reset();
    c.load.tangential_ratio = .4;
    c.load.press_steps = 3;
    c.rolling.emplace();
    c.rolling->amplitude_ratio = .3;
    c.rolling->steps_per_quarter = 2;
    c.rolling->speed = 1e-3;
    const auto path = contact::make_load_path(c, 20, half_space_scales(c).contact_radius);
    // Every step takes a second.
    const auto shift = [&](const Case& substrate) {
        const auto model = bem::make_model(substrate, 1, bem::Body::layer);
        StepRecord last;
        for (const auto* steps : {&path.pressing, &path.loading, &path.period, &path.period})
            for (LoadStep step : *steps) {
                step.duration = 1;
                last = model->advance(step);
            }
        EXPECT_TRUE(model->audit().passed());
        return last.shift[0];
    };
    Case on_ground = c;
    on_ground.relaxation->bulk = contact::Relaxation::Bulk::proportional;
    on_ground.layer.base = Case::Base::half_space;
    on_ground.layer.ground = contact::Material{4e6, .4};
    Case periodic = c;
    periodic.period = 40e-3;
    for (Case part : {c, on_ground, periodic}) {
        const double relaxed = shift(with_relaxing_ratio(part, 1));
        const double glassy = shift(with_relaxing_ratio(part, 1 + ratio));
        part.relaxation->branches[0].time = 1e-9;
        EXPECT_NEAR(shift(part) / relaxed, 1, 3e-6);
        part.relaxation->branches[0].time = 1e9;
        EXPECT_NEAR(shift(part) / glassy, 1, 3e-6);
        EXPECT_LT(glassy, .9 * relaxed);
    }
}

// An indenter that does not relax has its share of the compliance: between a body that relaxes
// wholly and one that does not at all, at the creep of both in series.
TEST(BemViscoelastic, ElasticIndenterDoesNotRelax) {
    Case c = rubber(15);
    c.indenter.material = contact::Material{3 * shear, .5};
    const auto model = bem::make_model(c, 1);
    const double force = hertz_force(shear, 3e-4);
    model->advance(step(NormalControl::Kind::force, force, 0));
    for (int k = 1; k <= 10; ++k) {
        const double d = model->advance(step(NormalControl::Kind::force, force, .1)).indentation;
        const double soft = creep(k * .1) * shear + 1;
        EXPECT_NEAR(d / (3e-4 * std::pow(soft, 2. / 3)), 1, .001) << k;
    }
    EXPECT_TRUE(model->audit().passed());
}

// rigs.md, 5: eta = 40 Pa s against G1 = 1.7 MPa at 0.2 Hz: the thesis may treat it as elastic.
TEST(BemViscoelastic, RigIsElastic) {
    Case c = bem::rig_case(.24, .56, 4);
    c.rolling->steps = Case::Steps::per_quarter;
    c.rolling->run_all = true;
    const auto elastic = bem::run_bem(c);
    c.relaxation = contact::Relaxation{{{1, 40 / c.substrate.shear_modulus()}}, {}};
    c.rolling->speed = 1e-3;
    c.load.hold = 60;
    const auto rubber = bem::run_bem(c);
    EXPECT_NEAR(rubber.static_shift / elastic.static_shift, 1, 1e-4);
    for (std::size_t n = 0; n < 4; ++n)
        EXPECT_NEAR(rubber.shift_per_period[n] / elastic.shift_per_period[n], 1, 1e-4);
    EXPECT_NE(rubber.shift_per_period[3], elastic.shift_per_period[3]);
}

}  // namespace
}  // namespace tricontact::bem_viscoelastic_test
