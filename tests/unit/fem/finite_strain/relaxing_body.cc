#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "contact/base/error.h"
#include "tests/unit/fem/finite_strain/maxwell_reference.h"
#include "tests/unit/fem/finite_strain/strained_block.h"
#include "tests/unit/fem/layer_problems.h"

namespace tricontact::relaxing_body_test {
namespace {

using contact::Relaxation;
using test::BlockSpec;
using test::StrainedBlock;
using test::Tensor;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double rounding = 1e-12;

const Relaxation several{{{1.6, .35}, {.5, 4.}, {.9, 30.}}};
const Relaxation one{{{1.6, .35}}};

StrainedBlock block_of(const Relaxation& relaxation, double c01_ratio = 0, int n = 1) {
    return StrainedBlock({{3e6, .5}, c01_ratio, relaxation, n});
}

using Motion = std::function<Tensor(double)>;

/// The linear substrate's law, step by step: 2 G_inf (e + sum h_i) of a strain in its direction.
class LinearRelaxation {
  public:
    explicit LinearRelaxation(const Relaxation& relaxation)
        : relaxation_(relaxation), h_(relaxation.branches.size()) {}
    double stress(double strain, double duration) {
        const contact::RelaxationStep step(relaxation_, duration);
        double sum = strain;
        for (std::size_t b = 0; b < h_.size(); ++b) {
            h_[b] = step.decay[b] * h_[b] + step.gain[b] * (strain - strain_);
            sum += h_[b];
        }
        strain_ = strain;
        return sum;
    }

  private:
    Relaxation relaxation_;
    std::vector<double> h_;
    double strain_ = 0;
};

/// Largest error of the deviatoric stress over the largest stress, in a history of steps of one
/// duration, against the linear law. `shape`: its strain for the amplitude 1.
double linear_error(double amplitude, double duration, const Motion& motion, const Tensor& shape) {
    auto block = block_of(several, .2);
    LinearRelaxation linear(several);
    double error = 0, largest = 0;
    for (const double factor : {1., .3, -.8, -.8, 0., .6, .6}) {
        const auto step = block.step(motion(amplitude * factor), duration);
        const double exact = linear.stress(amplitude * factor, duration) * 2 * block.shear_modulus;
        error = std::max(error, (test::dev(step.piola) - exact * shape).norm());
        largest = std::max(largest, std::abs(exact));
    }
    return error / largest;
}

// Strains of both kinds, at durations from much shorter to much longer than relaxation: what
// differs from the linear exponential formula is of the second order of the strain.
TEST(RelaxingBody, SmallStrainsRelaxAsTheLinearSubstrate) {
    const Tensor stretch = Eigen::Vector3d(-.5, -.5, 1).asDiagonal();
    Tensor shear = Tensor::Zero();
    shear(0, 2) = shear(2, 0) = .5;
    const std::vector<std::pair<Motion, Tensor>> motions{
        {[](double e) { return test::uniaxial(1 + e); }, stretch},
        {[](double e) { return test::simple_shear(e); }, shear}};
    for (const auto& [motion, shape] : motions)
        for (const double x : {0., .01, 1., 100., infinite}) {
            const double duration = x * several.branches[1].time;
            std::vector<double> errors;
            for (const double amplitude : {4e-3, 2e-3, 1e-3})
                errors.push_back(linear_error(amplitude, duration, motion, shape));
            for (const double order : test::orders(errors)) EXPECT_NEAR(order, 1, .03) << x;
            // Nothing of the first order is left; F itself is rounded to 1e-9 of this strain.
            EXPECT_LT(linear_error(1e-7, duration, motion, shape), 1e-6) << x;
        }
}

// At once all springs carry, each of the same elasticity; in infinite time only the first.
TEST(RelaxingBody, NoTimeAndAllTimeAreHyperelastic) {
    for (const double c01_ratio : {0., .3})
        for (const Tensor& f : {test::uniaxial(1.6), test::simple_shear(.9)}) {
            const Tensor b = f * f.transpose();
            auto block = block_of(several, c01_ratio);
            const double g = block.shear_modulus;
            const Tensor relaxed =
                test::mooney_rivlin(b, g / 2 * (1 - c01_ratio), g / 2 * c01_ratio);
            const double ratio = several.instantaneous_ratio();
            const auto at_once = block.step(f, 0);
            EXPECT_NEAR((test::dev(at_once.cauchy) - ratio * relaxed).norm() / g, 0, rounding);
            EXPECT_NEAR(at_once.energy / at_once.relaxed, ratio, rounding);
            EXPECT_EQ(at_once.dissipated, 0);
            const auto held = block.step(f, infinite);
            EXPECT_NEAR((test::dev(held.cauchy) - relaxed).norm() / g, 0, rounding);
            EXPECT_NEAR(held.energy / held.relaxed, 1, rounding);
            EXPECT_GT(held.dissipated, 0);
            // Infinitely slowly to another strain: the same.
            const Tensor other = test::uniaxial(.7);
            const auto slow = block.step(other, infinite);
            EXPECT_NEAR((test::dev(slow.cauchy) - test::mooney_rivlin(other * other.transpose(),
                                                                      g / 2 * (1 - c01_ratio),
                                                                      g / 2 * c01_ratio))
                                .norm() /
                            g,
                        0, rounding);
            EXPECT_NEAR(slow.dissipated / slow.energy, 0, rounding);
        }
}

/// In n steps of the time `end` along the motion; the last one's stress, and sums over the steps.
struct Sums {
    Tensor stress;
    double dissipated = 0, imbalance = 0, imbalance_of_forces = 0;
};
Sums run(StrainedBlock& block, const Motion& motion, double end, int n) {
    Sums sums;
    Tensor f = motion(0), piola = Tensor::Zero();
    double energy = 0, relaxed = 0;
    for (int i = 1; i <= n; ++i) {
        const Tensor next = motion(end * i / n);
        const auto step = block.step(next, end / n);
        sums.stress = test::dev(step.cauchy);
        sums.dissipated += step.dissipated;
        const double stored = step.energy - energy;
        sums.imbalance += step.work - (stored - (step.relaxed - relaxed) + step.dissipated);
        sums.imbalance_of_forces +=
            ((piola + step.piola) / 2).cwiseProduct(next - f).sum() - (stored + step.dissipated);
        f = next, piola = step.piola, energy = step.energy, relaxed = step.relaxed;
    }
    return sums;
}

// Simple shear at a constant rate, and then constant: the ODE of the split F = F_e F_i, integrated
// as such.
TEST(RelaxingBody, SimpleShearConvergesToTheContinuousLaw) {
    for (const double c01_ratio : {0., .3}) {
        const Motion motion = [](double t) { return test::simple_shear(std::min(2. * t, 1.4)); };
        const double g = block_of(one).shear_modulus;
        const test::MaxwellReference reference{motion, one, g, c01_ratio};
        // 0.7 s and 1.4 s: twice the relaxation time of ramp, twice of rest.
        for (const double end : {.7, 1.4}) {
            const auto exact = reference.integrate(end);
            std::vector<double> errors, of_dissipation;
            for (const int n : {24, 48, 96, 192}) {
                auto block = block_of(one, c01_ratio);
                const Sums result = run(block, motion, end, n);
                errors.push_back((result.stress - exact.stress).norm() / exact.stress.norm());
                of_dissipation.push_back(std::abs(result.dissipated / exact.dissipated - 1));
            }
            EXPECT_LT(errors.back(), 5e-6);
            for (const double order : test::orders(errors)) EXPECT_NEAR(order, 2, .05) << end;
            EXPECT_LT(of_dissipation.back(), 2e-5);
            EXPECT_NEAR(test::orders(of_dissipation).back(), 2, .05) << end;
        }
    }
}

// A stretch applied at once and held.
TEST(RelaxingBody, HeldStretchConvergesToTheContinuousLaw) {
    const Motion motion = [](double) { return test::uniaxial(1.8); };
    const double g = block_of(one).shear_modulus, end = .7;
    for (const double c01_ratio : {0., .3}) {
        const auto exact = test::MaxwellReference{motion, one, g, c01_ratio}.integrate(end);
        std::vector<double> errors;
        for (const int n : {8, 16, 32, 64}) {
            auto block = block_of(one, c01_ratio);
            block.step(motion(0), 0);
            const Sums result = run(block, motion, end, n);
            errors.push_back((result.stress - exact.stress).norm() / exact.stress.norm());
        }
        EXPECT_LT(errors.back(), 1e-4);
        for (const double order : test::orders(errors)) EXPECT_NEAR(order, 2, .15);
    }
}

Tensor tumbling(double t) {
    const Tensor shear = test::simple_shear(.8 * std::sin(5 * t));
    return shear * test::uniaxial(1 + .3 * std::sin(3 * t)) * (1 + .05 * std::sin(4 * t));
}

// Forces' work, by the trapezoidal rule and as the body says, is stored or dissipated.
TEST(RelaxingBody, EnergyIsBalanced) {
    for (const double c01_ratio : {0., .3}) {
        std::vector<double> imbalance, of_forces;
        double dissipated = 0;
        for (const int n : {40, 80, 160, 320}) {
            auto block = block_of(several, c01_ratio);
            const Sums result = run(block, tumbling, 1.3, n);
            imbalance.push_back(std::abs(result.imbalance / result.dissipated));
            of_forces.push_back(std::abs(result.imbalance_of_forces / result.dissipated));
            dissipated = result.dissipated;
        }
        EXPECT_GT(dissipated, 0);
        EXPECT_LT(imbalance.back(), 1e-4);
        for (const double order : test::orders(imbalance)) EXPECT_GT(order, 1.8);
        for (const double order : test::orders(of_forces)) EXPECT_GT(order, 1.8);
    }
}

// Energies of one step of small strain are those of the linear law, however long it is.
TEST(RelaxingBody, SmallStrainsDissipateAsTheLinearSubstrate) {
    for (const double x : {.01, 1., 20.}) {
        const double before = 1e-6, after = -.4e-6, w = after - before;
        auto block = block_of(one);
        const double g = one.branches[0].ratio * block.shear_modulus;
        block.step(test::simple_shear(before), 0);
        const auto step = block.step(test::simple_shear(after), x * one.branches[0].time);
        const contact::StepIntegrals s(x);
        const double scale = g * before * before;
        const double exact = g * (before * before * s.ee + 2 * before * w * s.ew + w * w * s.ww);
        EXPECT_NEAR((step.dissipated - exact) / scale, 0, 1e-5);  // strains of 1e-6
        EXPECT_NEAR((step.work - g * w * (before * s.mean + w * s.drift)) / scale, 0, 1e-5);
    }
}

// Rotated while it is strained, differently at the end of each step.
TEST(RelaxingBody, RotationRotatesStresses) {
    auto block = block_of(several, .3), rotated = block_of(several, .3);
    for (int i = 1; i <= 8; ++i) {
        const Tensor f = tumbling(.1 * i), r = test::rotation(.7 * i, {1, -2, .1 * i});
        const auto step = block.step(f, .1 * i), other = rotated.step(r * f, .1 * i);
        EXPECT_NEAR((other.cauchy - r * step.cauchy * r.transpose()).norm() / step.cauchy.norm(), 0,
                    rounding);
        EXPECT_NEAR(other.dissipated / step.dissipated, 1, 100 * rounding);
    }
}

// Any strain in any time: never less than nothing is dissipated or stored, det C_i stays 1.
TEST(RelaxingBodySlow, DissipationIsNotNegative) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int trial = 0; trial < 400; ++trial) {
        auto block = block_of(several, trial % 2 == 0 ? 0 : .5);
        const double size = std::pow(10., -3 * std::abs(uniform(generator))) * .6;
        for (int i = 0; i < 6; ++i) {
            Tensor f;
            do
                f = Tensor::Identity() +
                    size * Tensor::NullaryExpr([&] { return uniform(generator); });
            while (f.determinant() < .1);
            const double kind = uniform(generator);
            const double duration = kind < -.9  ? 0
                                    : kind > .9 ? infinite
                                                : std::pow(10., 3 * uniform(generator));
            const auto step = block.step(f, duration);
            ASSERT_GE(step.dissipated, 0) << trial;
            ASSERT_GE(step.energy, step.relaxed * (1 - rounding)) << trial;
        }
    }
}

TEST(RelaxingBody, ViscousStrainKeepsItsVolume) {
    auto block = block_of(several, .3);
    double most = 0;
    for (int i = 1; i <= 2000; ++i) {
        block.step(tumbling(.05 * i), .05);
        for (const auto& e : block.memory.viscous) {
            Tensor c;
            c << 1 + 2 * e[0][0], 2 * e[5][0], 2 * e[4][0], 2 * e[5][0], 1 + 2 * e[1][0],
                2 * e[3][0], 2 * e[4][0], 2 * e[3][0], 1 + 2 * e[2][0];
            most = std::max(most, std::abs(c.determinant() - 1));
        }
    }
    EXPECT_LT(most, 1e-14);  // rounding of one step: it does not add up
}

// Below nu = 1/2 volumes relax with the same function: at small strains, pressures that a
// linear Maxwell solid has, energies as well. No order of the strain is left: q is linear in e.
TEST(RelaxingBody, VolumesRelaxAsTheLinearSubstrate) {
    StrainedBlock block({{3e6, .3}, .2, several, 1});
    const double bulk = block.discretisation.moduli[0].bulk;
    std::vector<double> h(several.branches.size());
    double old = 0, stored = 0;
    int n_steps = 0;
    auto state = block.body.at_rest();
    for (const double x : {0., .02, 1., 100., infinite, 1., .3}) {
        const double duration = x * several.branches[1].time;
        const double strain = std::cos(3. * n_steps++) * 1e-2;
        const Tensor f = (1 + strain) * Tensor::Identity();
        state.displacement = block.state_of(f).displacement;
        const auto step = block.body.begin(block.memory, duration);
        // Displacements are given: pressures follow in one go.
        fem::StrainedBody::Response response;
        for (int k = 0; k < 2; ++k) {
            block.body.evaluate(state, step, response);
            const std::vector<double> no_change(state.displacement.size());
            block.body.add(no_change, response, step, state);
        }
        block.body.evaluate(state, step, response);
        const auto energies = block.body.finish(state, step, block.memory);

        const double e = f.determinant() - 1, change = e - old;
        const contact::RelaxationStep linear(several, duration);
        double pressure = e, energy = e * e, dissipated = 0;
        for (std::size_t b = 0; b < h.size(); ++b) {
            const double ratio = several.branches[b].ratio;
            const contact::StepIntegrals s(duration / several.branches[b].time);
            dissipated += h[b] * h[b] / ratio * s.ee + 2 * h[b] * change * s.ew +
                          ratio * change * change * s.ww;
            h[b] = linear.decay[b] * h[b] + linear.gain[b] * change;
            pressure += h[b];
            energy += h[b] * h[b] / ratio;
        }
        old = e;
        const double scale = bulk * 1e-2;
        EXPECT_NEAR(
            block.piola(response.force).trace() / 3 / (scale * std::pow(f.determinant(), 2. / 3)),
            bulk * pressure / scale, rounding)
            << x;
        EXPECT_NEAR(response.energy / block.volume / (scale * 1e-2),
                    bulk * energy / 2 / (scale * 1e-2), rounding);
        EXPECT_NEAR(energies.dissipated / block.volume / (scale * 1e-2),
                    bulk * dissipated / (scale * 1e-2), rounding);
        // What strains the branches is stored in them or lost.
        const double springs = bulk / 2 * e * e, in_branches = bulk * energy / 2 - springs;
        EXPECT_NEAR((energies.work - energies.dissipated) / block.volume / (scale * 1e-2),
                    (in_branches - stored) / (scale * 1e-2), rounding);
        stored = in_branches;
    }
}

TEST(RelaxingBody, RefusesWhatNoSolidHas) {
    const fem::Discretisation layer(test::small_layer());
    EXPECT_THROW(fem::StrainedBody(layer, {0., 0.}, {{{-1., 2.}}}), contact::InputError);
}

}  // namespace
}  // namespace tricontact::relaxing_body_test
