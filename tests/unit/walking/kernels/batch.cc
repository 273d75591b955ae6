#include "walking/kernels/batch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/walking/sets.h"
#include "walking/machine/stretch_recorder.h"
#include "walking/machine/velocity_verlet.h"
#include "walking/machine/walk_case.h"

namespace tricontact::walking::batch_test {
namespace {

constexpr double step = 1e-3;

// Machines about set B that differ from each other; more than fill the vectors of any kernel.
std::vector<Machine> machines(Machine::Model model = Machine::Model::two_spot, int n = 50) {
    std::vector<Machine> result;
    for (int i = 0; i < n; ++i) {
        Kappas kappas = set_b();
        kappas.kappa5 += 0.001 * i;
        kappas.kappa8 -= 0.01 * i;
        result.push_back({.kappas = kappas, .model = model});
    }
    return result;
}

std::vector<Motion> starts_of(std::span<const Machine> machines) {
    std::vector<Motion> starts;
    for (const Machine& machine : machines)
        starts.push_back(motion_at_start(machine, {.z = 1.1, .x_velocity = 0.2}));
    return starts;
}

Batch batch_of(std::span<const Machine> machines, Kernel kernel = best_kernel()) {
    return {machines, starts_of(machines), step, kernel};
}

class BatchOf : public testing::TestWithParam<Kernel> {};
INSTANTIATE_TEST_SUITE_P(Kernels, BatchOf, testing::ValuesIn(available_kernels()),
                         [](const auto& kernel) { return name_of(kernel.param); });

/// Largest difference of coordinates and velocities over their scale in the machine.
double difference(const Machine& machine, const Motion& a, const Motion& b) {
    const double length = static_displacement(machine), speed = machine.kappas.kappa6;
    double most = std::abs(a.time - b.time);
    for (const double value : {a.base - b.base, a.x - b.x, a.z - b.z, a.phi - b.phi})
        most = std::max(most, std::abs(value) / length);
    for (const double value : {a.x_velocity - b.x_velocity, a.z_velocity - b.z_velocity,
                               a.phi_velocity - b.phi_velocity})
        most = std::max(most, std::abs(value) / speed);
    for (std::size_t i = 0; i < a.spots.size(); ++i)
        for (const double value :
             {a.spots[i].normal - b.spots[i].normal, a.spots[i].tangential - b.spots[i].tangential,
              a.spots[i].flank - b.spots[i].flank})
            most = std::max(most, std::abs(value) / length);
    return most;
}

// Before chaos has made anything of it rounding stays rounding.
constexpr double rounding = 1e-9;

TEST_P(BatchOf, MovesEveryMachineAsVelocityVerletDoes) {
    for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
        const std::vector<Machine> all = machines(model);
        Batch batch = batch_of(all, GetParam());
        batch.advance(5000, {});
        for (std::size_t i = 0; i < all.size(); i += 7) {
            VelocityVerlet one(all[i], starts_of(all)[i], step);
            for (int n = 0; n < 5000; ++n) one.advance();
            EXPECT_LT(difference(all[i], batch.motion(i), one.motion()), rounding) << i;
        }
    }
}

TEST_P(BatchOf, MechanismsCanBeTakenAway) {
    for (const Mechanisms mechanisms :
         {Mechanisms{.vertical = false}, Mechanisms{.rotation = false}}) {
        const Machine machine{.kappas = set_b(), .mechanisms = mechanisms};
        const Motion start = motion_at_start(machine, {.z = 1.1});
        Batch batch(std::span(&machine, 1), std::span(&start, 1), step, GetParam());
        batch.advance(5000, {});
        VelocityVerlet one(machine, start, step);
        for (int n = 0; n < 5000; ++n) one.advance();
        EXPECT_LT(difference(machine, batch.motion(0), one.motion()), rounding);
    }
}

void expect_near(const StretchSums& a, const StretchSums& b, const Machine& machine) {
    const double n = static_cast<double>(b.steps), speed = machine.kappas.kappa6;
    const double rest = static_displacement(machine);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_NEAR(a.spring_force, b.spring_force, rounding * n * rest);
    EXPECT_NEAR(a.kinetic_energy, b.kinetic_energy, rounding * b.kinetic_energy);
    EXPECT_NEAR(a.z_min, b.z_min, rounding * rest);
    EXPECT_NEAR(a.z_max, b.z_max, rounding * rest);
    EXPECT_NEAR(a.phi_min, b.phi_min, rounding * rest);
    EXPECT_NEAR(a.phi_max, b.phi_max, rounding * rest);
    for (std::size_t i = 0; i < 2; ++i) {
        const SpotSums &spot = a.spots[i], &other = b.spots[i];
        EXPECT_EQ(spot.sticking, other.sticking);
        EXPECT_NEAR(spot.velocity, other.velocity, rounding * n * speed);
        EXPECT_NEAR(spot.velocity_squared, other.velocity_squared, rounding * n * speed * speed);
        EXPECT_NEAR(spot.normal, other.normal, rounding * n * rest);
        EXPECT_NEAR(spot.normal_squared, other.normal_squared, rounding * n * rest * rest);
        EXPECT_NEAR(spot.normal_velocity, other.normal_velocity, rounding * n * rest * speed);
    }
}

TEST_P(BatchOf, SumsUpTheStepsOfEveryMachineAsTheRecorderDoes) {
    constexpr int n = 5000, before = 1000;
    for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
        const std::vector<Machine> all = machines(model);
        Batch batch = batch_of(all, GetParam());
        std::vector<StretchSums> sums(all.size());
        batch.advance(before, {});
        batch.advance(1, sums);
        batch.advance(n - before - 1, sums);
        for (std::size_t i = 0; i < all.size(); i += 7) {
            const Motion start = starts_of(all)[i];
            VelocityVerlet run(all[i], start, step);
            StretchRecorder recorder(all[i], start, step);
            for (int k = 0; k < n; ++k) {
                if (k == before) recorder.take();
                run.advance();
                recorder.add(run.motion(), run.spot_steps());
            }
            expect_near(sums[i], recorder.sums(), all[i]);
        }
    }
}

TEST_P(BatchOf, StretchesDoNotChangeABit) {
    const std::vector<Machine> all = machines();
    Batch one = batch_of(all, GetParam());
    Batch two = batch_of(all, GetParam());
    one.advance(5000, {});
    for (const int n : {1, 2999, 1500, 500}) two.advance(n, {});
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(one.motion(i), two.motion(i)) << i;
}

TEST_P(BatchOf, AMachineThatTiltsTroublesNobody) {
    std::vector<Machine> all = machines();
    Batch alone = batch_of(all, GetParam());
    for (std::size_t i = 0; i < all.size(); i += 3) {
        all[i].kappas.kappa5 = all[i].kappas.kappa8 = 1.9;
        all[i].kappas.kappa6 = 1e-2;
    }
    Batch batch = batch_of(all, GetParam());
    std::vector<StretchSums> sums(all.size());
    constexpr int n = 20000;
    batch.advance(n, sums);
    alone.advance(n, {});
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Motion motion = batch.motion(i);
        if (i % 3 != 0) {
            EXPECT_EQ(motion, alone.motion(i)) << i;
            EXPECT_FALSE(batch.tilted(i));
            EXPECT_EQ(sums[i].steps, n);
            continue;
        }
        ASSERT_GT(all[i].kappas.kappa5, critical_friction(all[i].kappas));
        ASSERT_TRUE(batch.tilted(i)) << i;
        EXPECT_EQ(*batch.tilted(i), motion.time);
        EXPECT_NEAR(static_cast<double>(sums[i].steps) * step, motion.time, 1e-9);
        EXPECT_LE(std::max(sums[i].phi_max, -sums[i].phi_min), tilting_limit(all[i]));
        EXPECT_TRUE(std::isfinite(sums[i].spring_force + motion.z_velocity + motion.x));
        // Not long before: at this speed two thousand steps lead beyond.
        EXPECT_GT(std::abs(motion.phi) + 2048 * step * std::abs(motion.phi_velocity),
                  tilting_limit(all[i]));
    }
}

TEST(Batch, VectorsWithFusedMultiplyAddAgreeToTheBitAndSoDoThoseWithout) {
    for (const auto model : {Machine::Model::two_spot, Machine::Model::prism}) {
        const std::vector<Machine> all = machines(model);
        std::vector<std::vector<Motion>> motions;
        for (const Kernel kernel : available_kernels()) {
            Batch batch = batch_of(all, kernel);
            batch.advance(50000, {});
            motions.emplace_back();
            for (std::size_t i = 0; i < all.size(); ++i) motions.back().push_back(batch.motion(i));
        }
        for (std::size_t pair = 0; pair + 1 < motions.size(); pair += 2)
            EXPECT_EQ(motions[pair], motions[pair + 1]) << pair;
    }
}

TEST(Batch, RefusesWhatLanesDoNotKnow) {
    const auto refuses = [](const Machine& machine) {
        const Motion start = motion_at_start(machine);
        EXPECT_THROW(Batch(std::span(&machine, 1), std::span(&start, 1), step),
                     std::invalid_argument);
    };
    Machine machine{.kappas = set_b()};
    const Motion start = motion_at_start(machine);
    EXPECT_NO_THROW(Batch(std::span(&machine, 1), std::span(&start, 1), step));
    refuses({.kappas = set_b(), .model = Machine::Model::spots, .spots = {{-1}, {1}}});
    refuses({.kappas = set_b(), .bed = Bed{}});
    refuses({.kappas = set_b(), .mechanisms = {.coupling = false}});
    refuses({.kappas = set_b(), .excitation = {.moment = 1e-5, .frequency = 1}});
    machine.kappas.kappa5 = 0;
    refuses(machine);
    machine.kappas = set_b();
    machine.kappas.kappa1 = 0;
    refuses(machine);

    const std::vector<Machine> mixed{{.kappas = set_b()},
                                     {.kappas = set_b(), .model = Machine::Model::prism}};
    EXPECT_THROW(batch_of(mixed), std::invalid_argument);
    EXPECT_THROW(Batch(mixed, std::span(&start, 1), step), std::invalid_argument);
    std::vector<StretchSums> one_too_many(51);
    Batch batch = batch_of(machines());
    EXPECT_THROW(batch.advance(1, one_too_many), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::walking::batch_test
