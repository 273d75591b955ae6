#include "experiments/identification/estimation/identification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <tuple>

#include "contact/case.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::experiments::identification_test {
namespace {

constexpr double normal_force = 21.1;
constexpr double young = 5.2e6, friction = .57;
using Values = std::vector<double>;

contact::Case rig(double modulus, double mu) {
    contact::Case c;
    c.indenter.radius = 40e-3;
    c.substrate = {modulus, .5};
    c.friction.coefficient = mu;
    c.load.normal_force = normal_force;
    return c;
}

/// Cattaneo and Mindlin's shift at all forces.
std::vector<double> shifts(const std::vector<double>& forces, double modulus, double mu) {
    std::vector<double> values;
    for (const double force : forces)
        values.push_back(contact::half_space_scales(rig(modulus, mu)).unit_shift *
                         theory::static_shift_ratio(force / (mu * normal_force)));
    return values;
}

std::vector<double> forces_up_to(double largest, int n) {
    std::vector<double> forces;
    for (int i = 1; i <= n; ++i) forces.push_back(largest * i / n);
    return forces;
}

IdentificationTask shift_task(const std::vector<double>& forces) {
    IdentificationTask task;
    task.parameters = {young_parameter(1e6), friction_parameter(forces.back() / normal_force)};
    task.tables = {{"static-shift", shifts(forces, young, friction), {}}};
    task.model = [forces](const Values& v) { return shifts(forces, v[0], v[1]); };
    return task;
}

/// One of both given, as it is.
IdentificationTask young_task(const std::vector<double>& forces) {
    IdentificationTask task = shift_task(forces);
    task.parameters.pop_back();
    task.model = [forces](const Values& v) { return shifts(forces, v[0], friction); };
    return task;
}

void add_noise(IdentificationTask& task, double standard_deviation, std::mt19937& generator) {
    std::normal_distribution<double> noise(0, standard_deviation);
    for (ObservedTable& table : task.tables)
        for (double& value : table.observed) value += noise(generator);
}

bool covers(const Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

TEST(Identification, ExactShiftsGiveTheirModulusAndFrictionBack) {
    const Identification found = identify(shift_task(forces_up_to(11, 12)));
    // The search stops at 1e-8 of the properties; least squares then go on to rounding.
    EXPECT_NEAR(found.best()[0] / young, 1, 1e-8);
    EXPECT_NEAR(found.best()[1] / friction, 1, 1e-8);
    EXPECT_EQ(found.degrees_of_freedom, 10);
    EXPECT_NEAR(found.r_squared, 1, 1e-12);
    ASSERT_TRUE(found.correlation(0, 1));
    // More friction and a stiffer substrate both make the same shift smaller.
    EXPECT_LT(*found.correlation(0, 1), -.5);
}

// An interval of 90 % is to hold the truth in 90 of 100 measurements. The share among 100 has a
// standard deviation of 3 %; four of them are allowed.
class Coverage : public testing::TestWithParam<bool> {};

TEST_P(Coverage, IsThatClaimed) {
    constexpr int n = 100;
    constexpr double noise = 2e-6;
    std::mt19937 generator(20240613);
    const auto exact = shift_task(forces_up_to(11, 12));
    int n_linearised = 0, n_young = 0, n_friction = 0;
    double goodness = 0;
    for (int i = 0; i < n; ++i) {
        IdentificationTask task = exact;
        task.confidence = .9;
        if (GetParam()) task.tables[0].standard_errors.assign(12, noise);
        add_noise(task, noise, generator);
        const Identification found = identify(task);
        const auto& [e, mu] = std::tie(found.parameters[0], found.parameters[1]);
        n_linearised += covers({e.low, e.high}, young);
        n_young += covers(e.likelihood, young);
        n_friction += covers(mu.likelihood, friction);
        goodness += found.goodness.value_or(.5) / n;
    }
    const double allowed = 4 * std::sqrt(.9 * .1 / n);
    EXPECT_NEAR(double(n_linearised) / n, .9, allowed);
    EXPECT_NEAR(double(n_young) / n, .9, allowed);
    EXPECT_NEAR(double(n_friction) / n, .9, allowed);
    EXPECT_NEAR(goodness, .5, 4 / std::sqrt(12. * n));  // uniform between 0 and 1
}

INSTANTIATE_TEST_SUITE_P(ErrorsKnownOrEstimated, Coverage, testing::Bool());

TEST(Identification, SmallForcesCannotTellTheFriction) {
    std::mt19937 generator(7);
    IdentificationTask task = shift_task(forces_up_to(.6, 8));  // 5 % of mu F_N
    task.tables[0].standard_errors.assign(8, 80e-9);
    add_noise(task, 80e-9, generator);
    const Identification found = identify(task);
    EXPECT_TRUE(std::isinf(found.parameters[1].likelihood.high));
    EXPECT_LT(found.parameters[1].likelihood.low, friction);
    EXPECT_GE(found.parameters[1].likelihood.low, task.parameters[1].low);
    // But the slope is that of a sticking contact: 2 G* a tells E.
    EXPECT_TRUE(covers(found.parameters[0].likelihood, young));
    EXPECT_TRUE(std::isfinite(found.parameters[0].likelihood.high));
}

TEST(Identification, FrictionIsNeverBelowWhatHeld) {
    std::mt19937 generator(3);
    IdentificationTask task = shift_task(forces_up_to(.99 * friction * normal_force, 6));
    task.tables[0].standard_errors.assign(6, 20e-6);
    add_noise(task, 20e-6, generator);
    const Identification found = identify(task);
    EXPECT_GE(found.best()[1], task.parameters[1].low);
    EXPECT_GE(found.parameters[1].likelihood.low, task.parameters[1].low);
}

TEST(Identification, OneParameterAlone) {
    const auto forces = forces_up_to(11, 5);
    EXPECT_NEAR(identify(young_task(forces)).best()[0] / young, 1, 1e-8);
    IdentificationTask task = shift_task(forces);
    task.parameters.erase(task.parameters.begin());
    task.model = [forces](const Values& v) { return shifts(forces, young, v[0]); };
    EXPECT_NEAR(identify(task).best()[0] / friction, 1, 1e-8);
}

// U is E^(-2/3) to rounding if mu is known, so that ln E is a normal variable's logarithm: the
// edges follow from the least squares of a scale factor, in closed form.
TEST(Identification, LikelihoodOfAModulusAloneIsThatOfAFactor) {
    std::mt19937 generator(11);
    IdentificationTask task = young_task(forces_up_to(11, 9));
    const auto unit = task.tables[0].observed;
    constexpr double error = 5e-6;
    task.tables[0].standard_errors.assign(unit.size(), error);
    add_noise(task, error, generator);
    double xx = 0, xy = 0;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        xx += unit[i] * unit[i];
        xy += unit[i] * task.tables[0].observed[i];
    }
    const double factor = xy / xx, half_width = 1.959963984540054 * error / std::sqrt(xx);
    const Identification found = identify(task);
    const auto modulus = [](double k) { return young * std::pow(k, -1.5); };
    EXPECT_NEAR(found.best()[0] / modulus(factor), 1, 1e-8);
    EXPECT_NEAR(found.parameters[0].likelihood.low / modulus(factor + half_width), 1, 1e-7);
    EXPECT_NEAR(found.parameters[0].likelihood.high / modulus(factor - half_width), 1, 1e-7);
    const Profile profile = profile_of(task, found, 0, 21);
    EXPECT_GT(profile.sum_of_squares.front(), found.parameters[0].level);
    EXPECT_GT(profile.sum_of_squares.back(), found.parameters[0].level);
}

TEST(Identification, RefusesWhatIsNoTask) {
    auto task = shift_task({5, 11});
    EXPECT_THROW(identify(task), std::invalid_argument);  // two observations, two parameters
    task = shift_task({5, 8, 11});
    task.parameters[1].low = 0;
    EXPECT_THROW(identify(task), std::invalid_argument);
    task.parameters.clear();
    EXPECT_THROW(identify(task), std::invalid_argument);
}

}  // namespace
}  // namespace tricontact::experiments::identification_test
