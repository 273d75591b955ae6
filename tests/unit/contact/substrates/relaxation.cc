#include "contact/substrates/relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "contact/base/error.h"

namespace tricontact::contact::relaxation_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Relaxation relaxation(std::vector<Relaxation::Branch> branches) {
    return {.branches = std::move(branches), .bulk = Relaxation::Bulk::proportional};
}

// rigs.md, viscoelasticity: G' = G1 + G2 (wt)^2/(1+(wt)^2), G'' = G2 wt/(1+(wt)^2), t = eta/G2.
TEST(Relaxation, DynamicModulusOfTheStandardSolid) {
    const double g1 = 1.7, g2 = 0.6, eta = 0.03, t = eta / g2;
    const Relaxation solid = relaxation({{g2 / g1, t}});
    for (const double omega : {0.1, 3., 20., 77., 1e4}) {
        const double x = omega * t;
        const auto modulus = g1 * solid.dynamic_ratio(omega);
        // A handful of rounded operations on numbers of order G1.
        EXPECT_NEAR(modulus.real(), g1 + g2 * x * x / (1 + x * x), 1e-14);
        EXPECT_NEAR(modulus.imag(), g2 * x / (1 + x * x), 1e-14);
    }
    EXPECT_DOUBLE_EQ(g1 * solid.instantaneous_ratio(), g1 + g2);
}

TEST(Relaxation, BranchesAddUp) {
    const Relaxation one = relaxation({{0.3, 0.2}}), other = relaxation({{0.8, 7.}});
    const Relaxation both = relaxation({{0.3, 0.2}, {0.8, 7.}});
    for (const double omega : {0.03, 1., 40.})
        EXPECT_NEAR(std::abs(both.dynamic_ratio(omega) -
                             (one.dynamic_ratio(omega) + other.dynamic_ratio(omega) - 1.)),
                    0, 1e-14);  // rounding of numbers of order 1
    EXPECT_DOUBLE_EQ(both.instantaneous_ratio(), 2.1);
}

TEST(Relaxation, ElasticWithoutBranches) {
    EXPECT_EQ(relaxation({}).instantaneous_ratio(), 1);
    EXPECT_EQ(relaxation({}).dynamic_ratio(3.), 1.);
    EXPECT_EQ(RelaxationStep(relaxation({}), 2.).stiffness, 1);
}

TEST(Relaxation, RefusesWhatNoSolidHas) {
    const auto message = [](double ratio, double time) -> std::string {
        try {
            check(relaxation({{0.5, 1.}, {ratio, time}}));
        } catch (const InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(message(0.2, 3.), "accepted");
    for (const double bad : {0., -0.2, infinite, std::nan("")}) {
        EXPECT_NE(message(bad, 3.).find("moduli of branches must be positive"), std::string::npos)
            << bad;
        EXPECT_NE(message(0.2, bad).find("times must be positive"), std::string::npos) << bad;
    }
}

TEST(RelaxationStep, WithoutTimeNothingRelaxesAndInInfiniteTimeEverything) {
    const Relaxation solid = relaxation({{0.3, 0.2}, {0.8, 7.}});
    const RelaxationStep at_once(solid, 0), forever(solid, infinite);
    EXPECT_DOUBLE_EQ(at_once.stiffness, solid.instantaneous_ratio());
    EXPECT_EQ(forever.stiffness, 1);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(at_once.decay[i], 1);
        EXPECT_EQ(at_once.gain[i], solid.branches[i].ratio);
        EXPECT_EQ(forever.decay[i], 0);
        EXPECT_EQ(forever.gain[i], 0);
    }
}

// What `steps` equal steps of a strain that rises linearly from 0 to 1 in `duration` leave in h.
std::vector<double> ramp(const Relaxation& solid, double duration, int steps,
                         std::vector<double> h) {
    const RelaxationStep step(solid, duration / steps);
    for (int k = 0; k < steps; ++k)
        for (std::size_t i = 0; i < h.size(); ++i)
            h[i] = step.decay[i] * h[i] + step.gain[i] / steps;
    return h;
}

TEST(RelaxationStep, IsExactForLinearStrain) {
    const Relaxation solid = relaxation({{0.3, 0.2}, {0.8, 7.}, {0.1, 4e3}});
    const std::vector<double> start{0.7, -0.4, 0.2};
    const double duration = 1.3;
    const auto once = ramp(solid, duration, 1, start), twice = ramp(solid, duration, 2, start);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [ratio, time] = solid.branches[i];
        // Hereditary integral of the rate 1/T over the age: g tau/T (1 - exp(-T/tau)).
        const double exact = start[i] * std::exp(-duration / time) +
                             ratio * time / duration * (1 - std::exp(-duration / time));
        // 1 - exp(-x) here loses x of its digits: 1e-16 tau/T = 3e-13 for the slowest branch.
        EXPECT_NEAR(once[i], exact, 1e-12);
        EXPECT_NEAR(twice[i], once[i], 1e-15);  // rounding of numbers below 1
    }
}

TEST(RelaxationStep, StrainHeldRelaxesAsTheSeries) {
    const Relaxation solid = relaxation({{0.3, 0.2}, {0.8, 7.}});
    const double wait = 2.5;
    const RelaxationStep jump(solid, 0), hold(solid, wait);
    double total = 1, expected = 1;
    for (std::size_t i = 0; i < 2; ++i) {
        total += hold.decay[i] * jump.gain[i];
        expected += solid.branches[i].ratio * std::exp(-wait / solid.branches[i].time);
    }
    EXPECT_DOUBLE_EQ(total, expected);
}

// Under strain cos(wt) in small steps the traction settles at |G*| cos(wt + delta), as the dynamic
// modulus says: the step and the modulus are those of one solid.
TEST(RelaxationStep, SmallStepsGiveTheDynamicModulusInSecondOrder) {
    const Relaxation solid = relaxation({{0.7, 0.3}, {0.4, 2.}});
    const double omega = 1.9, period = 2 * std::acos(-1.) / omega;
    const auto error = [&](int steps_per_period) {
        const RelaxationStep step(solid, period / steps_per_period);
        std::vector<double> h(2, 0.);
        double u = 1, worst = 0;
        const auto modulus = solid.dynamic_ratio(omega);
        const int n = 10 * steps_per_period;  // 10 periods: exp(-33/2) of the start is left
        for (int k = 1; k <= n; ++k) {
            const double angle = 2 * std::acos(-1.) * k / steps_per_period;
            const double next = std::cos(angle);
            double traction = next;
            for (std::size_t i = 0; i < 2; ++i) {
                h[i] = step.decay[i] * h[i] + step.gain[i] * (next - u);
                traction += h[i];
            }
            u = next;
            const double exact = modulus.real() * next - modulus.imag() * std::sin(angle);
            if (k > n - steps_per_period) worst = std::max(worst, std::abs(traction - exact));
        }
        return worst;
    };
    // Chords instead of the cosine: the order is 2; 3 % is the next term at 41 steps.
    EXPECT_NEAR(std::log2(error(41) / error(82)), 2, 0.03);
    EXPECT_NEAR(std::log2(error(82) / error(164)), 2, 0.03);
    EXPECT_LT(error(164), 1e-3);
}

}  // namespace
}  // namespace tricontact::contact::relaxation_test
