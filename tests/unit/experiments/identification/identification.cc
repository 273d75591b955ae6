#include "experiments/identification/identification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "contact/case.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::experiments::identification_test {
namespace {

constexpr double normal_force = 21.1;
const Properties truth{5.2e6, .57};

contact::Case rig(const Properties& p) {
    contact::Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {p.young, .5};
    c.friction_coefficient = p.friction;
    c.load.normal_force = normal_force;
    return c;
}

/// Cattaneo and Mindlin's shift at all forces.
std::vector<double> shifts(const std::vector<double>& forces, const Properties& p) {
    std::vector<double> values;
    for (const double force : forces)
        values.push_back(contact::half_space_scales(rig(p)).unit_shift *
                         theory::static_shift_ratio(force / (p.friction * normal_force)));
    return values;
}

std::vector<double> forces_up_to(double largest, int n) {
    std::vector<double> forces;
    for (int i = 1; i <= n; ++i) forces.push_back(largest * i / n);
    return forces;
}

IdentificationTask shift_task(const std::vector<double>& forces) {
    IdentificationTask task;
    task.observed = shifts(forces, truth);
    task.model = [forces](const Properties& p) { return shifts(forces, p); };
    task.start = {1e6, 0};
    task.least_friction = forces.back() / normal_force;
    return task;
}

void add_noise(IdentificationTask& task, double standard_deviation, std::mt19937& generator) {
    std::normal_distribution<double> noise(0, standard_deviation);
    for (double& value : task.observed) value += noise(generator);
}

bool covers(const Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

TEST(Identification, ExactShiftsGiveTheirModulusAndFrictionBack) {
    const Identification found = identify(shift_task(forces_up_to(11, 12)));
    // The search stops at 1e-8 of the properties; least squares then go on to rounding.
    EXPECT_NEAR(found.best.young / truth.young, 1, 1e-8);
    EXPECT_NEAR(found.best.friction / truth.friction, 1, 1e-8);
    EXPECT_EQ(found.degrees_of_freedom, 10);
    EXPECT_NEAR(found.r_squared, 1, 1e-12);
    ASSERT_TRUE(found.correlation);
    // More friction and a stiffer substrate both make the same shift smaller.
    EXPECT_LT(*found.correlation, -.5);
}

// An interval of 90 % is to hold the truth in 90 of 100 measurements. The share among 200 has a
// standard deviation of 2.1 %; four of them are allowed.
class Coverage : public testing::TestWithParam<bool> {};

TEST_P(Coverage, IsThatClaimed) {
    constexpr int n = 200;
    constexpr double noise = 2e-6;
    std::mt19937 generator(20240613);
    const auto exact = shift_task(forces_up_to(11, 12));
    int young_linearised = 0, young = 0, friction = 0;
    double goodness = 0;
    for (int i = 0; i < n; ++i) {
        IdentificationTask task = exact;
        task.confidence = .9;
        if (GetParam()) task.standard_errors.assign(task.observed.size(), noise);
        add_noise(task, noise, generator);
        const Identification found = identify(task);
        young_linearised += covers({found.young->low, found.young->high}, truth.young);
        young += covers(found.young->likelihood, truth.young);
        friction += covers(found.friction->likelihood, truth.friction);
        goodness += found.goodness.value_or(.5) / n;
    }
    const double allowed = 4 * std::sqrt(.9 * .1 / n);
    EXPECT_NEAR(double(young_linearised) / n, .9, allowed);
    EXPECT_NEAR(double(young) / n, .9, allowed);
    EXPECT_NEAR(double(friction) / n, .9, allowed);
    EXPECT_NEAR(goodness, .5, 4 / std::sqrt(12. * n));  // uniform between 0 and 1
}

INSTANTIATE_TEST_SUITE_P(ErrorsKnownOrEstimated, Coverage, testing::Bool());

TEST(Identification, SmallForcesCannotTellTheFriction) {
    std::mt19937 generator(7);
    IdentificationTask task = shift_task(forces_up_to(.6, 8));  // 5 % of mu F_N
    task.standard_errors.assign(8, 80e-9);
    add_noise(task, 80e-9, generator);
    const Identification found = identify(task);
    EXPECT_TRUE(std::isinf(found.friction->likelihood.high));
    EXPECT_LT(found.friction->likelihood.low, truth.friction);
    EXPECT_GE(found.friction->likelihood.low, task.least_friction);
    // But the slope is that of a sticking contact: 2 G* a tells E.
    EXPECT_TRUE(covers(found.young->likelihood, truth.young));
    EXPECT_TRUE(std::isfinite(found.young->likelihood.high));
}

TEST(Identification, FrictionIsNeverBelowWhatHeld) {
    std::mt19937 generator(3);
    IdentificationTask task = shift_task(forces_up_to(.99 * truth.friction * normal_force, 6));
    task.standard_errors.assign(6, 20e-6);
    add_noise(task, 20e-6, generator);
    const Identification found = identify(task);
    EXPECT_GE(found.best.friction, task.least_friction);
    EXPECT_GE(found.friction->likelihood.low, task.least_friction);
}

TEST(Identification, OnePropertyAlone) {
    IdentificationTask task = shift_task(forces_up_to(11, 5));
    task.friction_is_free = false;
    task.start.friction = truth.friction;
    EXPECT_NEAR(identify(task).best.young / truth.young, 1, 1e-8);
    EXPECT_FALSE(identify(task).friction);
    task.friction_is_free = true;
    task.young_is_free = false;
    task.start = {truth.young, 0};
    EXPECT_NEAR(identify(task).best.friction / truth.friction, 1, 1e-8);
    EXPECT_FALSE(identify(task).young);
}

// U is E^(-2/3) to rounding if mu is known, so that ln E is a normal variable's logarithm: the
// edges follow from the least squares of a scale factor, in closed form.
TEST(Identification, LikelihoodOfAModulusAloneIsThatOfAFactor) {
    std::mt19937 generator(11);
    IdentificationTask task = shift_task(forces_up_to(11, 9));
    task.friction_is_free = false;
    task.start.friction = truth.friction;
    const auto unit = task.observed;
    constexpr double error = 5e-6;
    task.standard_errors.assign(unit.size(), error);
    add_noise(task, error, generator);
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        xx += unit[i] * unit[i];
        xy += unit[i] * task.observed[i];
    }
    const double factor = xy / xx, half_width = 1.959963984540054 * error / std::sqrt(xx);
    const Identification found = identify(task);
    const auto young = [](double k) { return truth.young * std::pow(k, -1.5); };
    EXPECT_NEAR(found.best.young / young(factor), 1, 1e-8);
    EXPECT_NEAR(found.young->likelihood.low / young(factor + half_width), 1, 1e-7);
    EXPECT_NEAR(found.young->likelihood.high / young(factor - half_width), 1, 1e-7);
    const Profile profile = profile_of(task, found, Property::young, 21);
    EXPECT_GT(profile.sum_of_squares.front(), found.level_of_interval[0]);
    EXPECT_GT(profile.sum_of_squares.back(), found.level_of_interval[0]);
}

TEST(Identification, SumsOfSquaresAreUndefinedWhereTheContactSlides) {
    const auto task = shift_task(forces_up_to(11, 4));
    const auto sums = sums_of_squares(task, {5e6, truth.young}, {.4, truth.friction});
    EXPECT_TRUE(std::isnan(sums[0]));
    EXPECT_TRUE(std::isnan(sums[1]));
    EXPECT_GT(sums[2], 0);
    EXPECT_NEAR(sums[3], 0, 1e-20);
}

TEST(Identification, RefusesWhatIsNoTask) {
    auto task = shift_task({5, 11});
    EXPECT_THROW(identify(task), std::invalid_argument);  // two observations, two properties
    task = shift_task({5, 8, 11});
    task.least_friction = 0;
    EXPECT_THROW(identify(task), std::invalid_argument);
    task.young_is_free = task.friction_is_free = false;
    EXPECT_THROW(identify(task), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::experiments::identification_test
