#include "mdr/spring_memory.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace tricontact::spring_memory_test {
namespace {

using contact::Relaxation;
using mdr::SpringMemory;
using mdr::Window;

constexpr double forever = std::numeric_limits<double>::infinity();

// One spring whose deflection is prescribed.
class Spring {
  public:
    explicit Spring(const Relaxation& relaxation) : memory_(relaxation, 1) {}

    SpringMemory::Sums bend(double duration, double deflection) {
        memory_.begin(duration, {0, 1});
        force_ = memory_.stiffness() * (deflection - memory_.free_deflection()[0]);
        return memory_.end({0, 1}, {force_});
    }
    SpringMemory::Sums load(double duration, double force) {
        memory_.begin(duration, {0, 1});
        force_ = force;
        return memory_.end({0, 1}, {force_});
    }
    double force() const { return force_; }
    double deflection() const { return memory_.deflection()[0]; }

  private:
    SpringMemory memory_;
    double force_ = 0;
};

const Relaxation two_branches{{{.7, 2.}, {1.9, .03}}, {}};

TEST(MdrSpringMemory, StepInStrainThenHold) {
    Spring spring(two_branches);
    spring.bend(0, 3.);
    double time = 0;
    EXPECT_NEAR(spring.force(), 3 * (1 + .7 + 1.9), 1e-14);
    for (const double duration : {.01, .1, 1., 10.}) {
        spring.bend(duration, 3.);
        time += duration;
        const double exact = 3 * (1 + .7 * std::exp(-time / 2) + 1.9 * std::exp(-time / .03));
        EXPECT_NEAR(spring.force(), exact, 1e-13) << time;
    }
    spring.bend(forever, 3.);
    EXPECT_NEAR(spring.force(), 3, 1e-14);
}

TEST(MdrSpringMemory, RampIsExactInStepsOfAnyLength) {
    Spring spring(two_branches);
    double time = 0;
    for (const double duration : {1e-6, .02, .7, 3., 1e-3}) {
        time += duration;
        spring.bend(duration, 5 * time);
        double exact = 5 * time;
        for (const auto& [ratio, relaxes_in] : two_branches.branches)
            exact -= 5 * ratio * relaxes_in * std::expm1(-time / relaxes_in);
        EXPECT_NEAR(spring.force() / exact, 1, 1e-12) << time;
    }
}

// A standard solid bent for long, then free: at once it springs back to g/(1+g) u, then creeps
// back with the retardation time (1+g) tau.
double recovered(int n_steps) {
    constexpr double ratio = 1.5, relaxes_in = .2, time = .4;
    Spring spring({{{ratio, relaxes_in}}, {}});
    spring.bend(forever, 2.);
    spring.load(0, 0);
    EXPECT_NEAR(spring.deflection(), 2 * ratio / (1 + ratio), 1e-14);
    for (int k = 0; k < n_steps; ++k) spring.load(time / n_steps, 0);
    return spring.deflection() /
           (2 * ratio / (1 + ratio) * std::exp(-time / ((1 + ratio) * relaxes_in)));
}

TEST(MdrSpringMemory, FreeSpringCreepsBackToTheSecondOrder) {
    double error = recovered(8) - 1;
    for (const int n : {16, 33}) {
        const double finer = recovered(n) - 1;
        const double order = std::log(error / finer) / std::log(n == 16 ? 2. : 33. / 16);
        EXPECT_NEAR(order, 2, .02) << n;  // the next order is dt smaller
        error = finer;
    }
    EXPECT_LT(std::abs(error), 1e-4);
}

// Sines: pi G'' per cycle and amplitude squared, G'' = g w tau/(1 + w^2 tau^2), for each branch.
TEST(MdrSpringMemory, DissipationOfACycleIsTheLossModulus) {
    constexpr double omega = 4, amplitude = .3;
    const double exact =
        std::numbers::pi * amplitude * amplitude * two_branches.dynamic_ratio(omega).imag();
    double last_error = 0;
    for (const int n : {60, 120, 241}) {
        Spring spring(two_branches);
        double dissipated = 0, work = 0;
        constexpr int n_cycles = 12;  // the first ones swing in: exp(-2 pi 11/(w tau)) is left
        for (int k = 1; k <= n_cycles * n; ++k) {
            const double phase = 2 * std::numbers::pi * k / n;
            const auto sums =
                spring.bend(2 * std::numbers::pi / omega / n, amplitude * std::sin(phase));
            if (k <= (n_cycles - 1) * n) continue;
            dissipated += sums.dissipated;
            work += sums.work;
        }
        const double error = dissipated / exact - 1;
        EXPECT_NEAR(work / exact, 1, 1e-2);  // all that is done in a cycle is lost
        if (last_error != 0) {
            const double refinement = n == 120 ? 2. : 241. / 120;
            EXPECT_NEAR(std::log(last_error / error) / std::log(refinement), 2, .1) << n;
        }
        last_error = error;
    }
    EXPECT_LT(std::abs(last_error), 2e-4);  // (2 pi/241)^2/12 and a little more
}

TEST(MdrSpringMemory, OnlyItsWindowMoves) {
    SpringMemory memory(two_branches, 5);
    memory.begin(.1, {});
    memory.end({1, 3}, {9, 1, 2, 9, 9});
    EXPECT_EQ(memory.deflection()[0], 0);
    EXPECT_EQ(memory.deflection()[3], 0);
    EXPECT_NEAR(memory.deflection()[2], 2 * memory.deflection()[1], 1e-15);
    memory.grow(2);
    EXPECT_EQ(memory.size(), 9);
    EXPECT_GT(memory.deflection()[3], 0);
    memory.begin(.1, {3, 5});
    EXPECT_GT(memory.free_deflection()[3], 0);  // it has relaxed
    memory.forget();
    memory.begin(.1, {3, 5});
    EXPECT_EQ(memory.free_deflection()[3], 0);
}

// Work = stored + dissipated, and mean force = what many small steps find.
RC_GTEST_PROP(MdrSpringMemory, EveryStepBalancesItsEnergy, ()) {
    Spring spring(two_branches), fine(two_branches);
    double stored = 0, deflection = 0, work = 0, dissipated = 0;
    const int n = *rc::gen::inRange(1, 12);
    for (int k = 0; k < n; ++k) {
        const int exponent = *rc::gen::inRange(-12, 6);
        const double duration = exponent == -12 ? 0
                                : exponent == 5 ? forever
                                                : std::pow(10., exponent);
        const double target = *rc::gen::inRange(-100, 101) * .01;
        const auto sums = spring.bend(duration, target);
        RC_ASSERT(sums.law_error < 1e-14);
        RC_ASSERT(sums.dissipated >= -1e-16);
        RC_ASSERT(std::abs(sums.work - (sums.stored - stored) - sums.dissipated) < 1e-14);
        RC_ASSERT(std::abs(sums.work - sums.mean_force * (target - deflection)) < 1e-14);
        stored = sums.stored;
        // The same step in parts: nothing depends on where a straight line is cut.
        if (std::isinf(duration)) {
            fine.bend(duration, target);
        } else {
            const double share = *rc::gen::inRange(1, 100) * .01;
            const double middle = deflection + share * (target - deflection);
            for (const auto& [part, next] : {std::pair{share, middle}, {1 - share, target}}) {
                const auto piece = fine.bend(part * duration, next);
                work += piece.work;
                dissipated += piece.dissipated;
            }
            RC_ASSERT(std::abs(work - sums.work) < 1e-13);
            RC_ASSERT(std::abs(dissipated - sums.dissipated) < 1e-13);
        }
        RC_ASSERT(std::abs(fine.force() - spring.force()) < 1e-13);
        work = dissipated = 0;
        deflection = target;
    }
}

}  // namespace
}  // namespace tricontact::spring_memory_test
