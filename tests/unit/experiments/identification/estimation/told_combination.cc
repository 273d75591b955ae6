// What observations tell of parameters together, against forces that depend on a product by theory.

#include "experiments/identification/estimation/told_combination.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/case.h"

namespace tricontact::experiments::told_combination_test {
namespace {

constexpr double young = 4e6, radius = .04, force_error = .02;

FreeParameter radius_parameter() {
    return {.key = "indenter.radius",
            .name = "indenter_radius_m",
            .symbol = "R",
            .unit = "m",
            .low = radius / 100,
            .high = radius * 100,
            .start = 1.3 * radius};
}

std::vector<double> depths() {
    std::vector<double> all;
    for (int i = 1; i <= 12; ++i) all.push_back(4e-5 * i);
    return all;
}

contact::Case rig(const std::vector<double>& v) {
    contact::Case c;
    c.indenter.radius = v[1];
    c.substrate = {v[0], .5};
    return c;
}

/// Hertz: F = 4/3 E* R^(1/2) d^(3/2), so that E R^(1/2) is all that depths and forces tell.
std::vector<double> forces(const std::vector<double>& v) {
    std::vector<double> all;
    for (const double depth : depths()) {
        contact::Case c = rig(v);
        c.load.indentation = depth;
        all.push_back(contact::half_space_scales(c).normal_force);
    }
    return all;
}

/// Hertz: a^3 = 3/4 F R/E*: another product.
std::vector<double> radii(const std::vector<double>& v) {
    std::vector<double> all;
    for (int i = 1; i <= 12; ++i) {
        contact::Case c = rig(v);
        c.load.normal_force = i;
        all.push_back(contact::half_space_scales(c).contact_radius);
    }
    return all;
}

IdentificationTask task_of(const Prediction& model, std::vector<ObservedTable> tables) {
    IdentificationTask task{.parameters = {young_parameter(2e6), radius_parameter()},
                            .tables = std::move(tables),
                            .model = model};
    std::mt19937_64 random(5);
    std::normal_distribution<double> gauss;
    for (ObservedTable& table : task.tables)
        for (std::size_t i = 0; i < table.observed.size(); ++i)
            table.observed[i] += table.standard_errors[i] * gauss(random);
    return task;
}

TEST(ToldCombination, ForcesOfAHalfSpaceTellTheModulusTimesTheRootOfTheRadius) {
    const std::vector<double> truth{young, radius}, exact = forces(truth);
    const auto found = identify(
        task_of(forces, {{"depths", exact, std::vector<double>(exact.size(), force_error)}}));
    const auto told = told_combinations(found);
    ASSERT_EQ(told.size(), 1U);
    EXPECT_NEAR(told[0].exponents[1], .5, 1e-4);  // slopes are differences
    // Of the product's factor: sigma/sqrt(sum F^2).
    double squares = 0;
    for (const double force : exact) squares += force * force;
    EXPECT_NEAR(told[0].standard_error / (force_error / std::sqrt(squares)), 1, .02);
    EXPECT_NEAR(found.best()[0] * std::sqrt(found.best()[1]) / (young * std::sqrt(radius)), 1,
                4 * told[0].standard_error);
    EXPECT_TRUE(sentence(told[0], found)
                    .starts_with("E and R are identifiable only in the combination E R^0.50 ("));
    // Alone they are open.
    EXPECT_TRUE(std::isinf(found.parameters[0].standard_error));
    for (const ParameterEstimate& one : found.parameters) {
        EXPECT_TRUE(std::isinf(one.likelihood.high));
        EXPECT_EQ(one.likelihood.low, 0);
    }
}

// Two products tell both factors.
TEST(ToldCombination, ForcesAndRadiiTogetherTellBoth) {
    const std::vector<double> truth{young, radius};
    const auto both = [](const std::vector<double>& v) {
        auto all = forces(v);
        for (const double a : radii(v)) all.push_back(a);
        return all;
    };
    const auto found = identify(task_of(both, {{"depths", forces(truth), std::vector(12, .02)},
                                               {"radii", radii(truth), std::vector(12, 3e-5)}}));
    EXPECT_TRUE(told_combinations(found).empty());
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(found.best()[k] / truth[k], 1, 4 * found.logarithmic.standard_errors[k]);
    EXPECT_LT(found.logarithmic.standard_errors[0], .05);
}

// A half-space tells E/(1 - nu^2), and nu is between 0 and 1/2: so E is told to 7 %, which is no
// "only in the combination".
TEST(ToldCombination, NotWhereBoundsTellOneOfBoth) {
    const auto model = [](const std::vector<double>& v) {
        return forces({v[0] * .75 / (1 - v[1] * v[1]), radius});
    };
    IdentificationTask task =
        task_of(model, {{"depths", model({young, .4}), std::vector(12, force_error)}});
    task.parameters[1] = {.key = "substrate.poisson",
                          .name = "poisson",
                          .symbol = "nu",
                          .scale = FreeParameter::Scale::linear,
                          .low = 0,
                          .high = .5,
                          .start = .45};
    const auto found = identify(task);
    EXPECT_TRUE(told_combinations(found).empty());
    const auto& [low, high] = found.parameters[0].likelihood;
    EXPECT_NEAR(high / low, 1 / .75, .01);  // and the error of E*
    EXPECT_EQ(found.parameters[1].likelihood.low, 0);
    EXPECT_EQ(found.parameters[1].likelihood.high, .5);
}

// On a layer of known thickness the depth is measured against b: E and R are told by the curve's
// shape. Bonded incompressible layer, Dimitriadis et al. 2002, Biophys. J. 82, 2798, eq. 1.
TEST(ToldCombination, NotWhereTheLayerTellsThemApart) {
    const auto model = [](const std::vector<double>& v) {
        std::vector<double> all;
        for (const double depth : depths()) {
            const double x = std::sqrt(v[1] * depth) / 4e-3;
            const double growth =
                1 + 1.133 * x + 1.283 * x * x + .769 * x * x * x + .0975 * x * x * x * x;
            all.push_back(16. / 9 * v[0] * std::sqrt(v[1] * depth) * depth * growth);
        }
        return all;
    };
    const std::vector<double> truth{young, radius};
    const auto found = identify(task_of(model, {{"depths", model(truth), std::vector(12, .02)}}));
    EXPECT_TRUE(told_combinations(found).empty());
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(found.best()[k] / truth[k], 1, 4 * found.logarithmic.standard_errors[k]);
        EXPECT_LT(found.logarithmic.standard_errors[k], untold_error);
    }
}

// Errors that are not stated are told by each table's own residuals: those of radii are not those
// of forces.
TEST(JointTables, EstimateTheErrorOfEach) {
    const std::vector<double> truth{young, radius};
    const auto both = [](const std::vector<double>& v) {
        auto all = forces(v);
        for (const double a : radii(v)) all.push_back(a);
        return all;
    };
    IdentificationTask task = task_of(both, {{"depths", forces(truth), std::vector(12, .02)},
                                             {"radii", radii(truth), std::vector(12, 3e-5)}});
    for (ObservedTable& table : task.tables) table.standard_errors.clear();
    const auto found = identify(task);
    // An estimate by 11 degrees of freedom scatters by 21 %.
    EXPECT_NEAR(found.tables[0].standard_errors[0] / .02, 1, .7);
    EXPECT_NEAR(found.tables[1].standard_errors[0] / 3e-5, 1, .7);
    EXPECT_NEAR(found.tables[0].degrees_of_freedom + found.tables[1].degrees_of_freedom, 22, 1e-6);
    EXPECT_NEAR(found.sum_of_squares, 22, 1e-3);
    EXPECT_FALSE(found.goodness);
}

}  // namespace
}  // namespace tricontact::experiments::told_combination_test
