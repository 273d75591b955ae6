#include "experiments/identification/estimation/posterior.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::experiments::posterior_test {
namespace {

// y = x E by known errors: with the prior flat in ln E the posterior of E is nearly normal, of mean
// E_best and deviation sigma/sqrt(sum x^2). An input that changes E by c, one standard error, adds
// c to it in squares.
IdentificationTask line() {
    IdentificationTask task;
    task.parameters = {young_parameter(4e6)};
    task.tables = {{"line", {4e6, 8e6, 12e6, 16e6, 20e6}, std::vector<double>(5, 1e5)}};
    task.model = [](const std::vector<double>& v) {
        std::vector<double> values;
        for (int i = 1; i <= 5; ++i) values.push_back(i * v[0]);
        return values;
    };
    return task;
}

TEST(Posterior, OfALineIsTheNormalDensity) {
    const IdentificationTask task = line();
    const Posterior p = sample_posterior(task, identify(task), {});
    const double sigma = 1e5 / std::sqrt(55);
    EXPECT_GT(p.effective_size, 1000);
    EXPECT_NEAR((p.median[0] - 4e6) / sigma, 0, .15);
    // Quantiles of 2.5 % of a thousand independent points scatter by 0.09 sigma.
    EXPECT_NEAR((p.interval[0].high - 4e6) / sigma, 1.96, .3);
    EXPECT_NEAR((p.interval[0].low - 4e6) / sigma, -1.96, .3);
}

TEST(Posterior, HoldsTheErrorsOfInputs) {
    const IdentificationTask task = line();
    const double c = 5e4;
    const Posterior p = sample_posterior(task, identify(task), {{c}});
    const double sigma = std::hypot(1e5 / std::sqrt(55), c);
    EXPECT_NEAR((p.interval[0].high - p.interval[0].low) / (2 * 1.96 * sigma), 1, .15);
}

// Another observation lies where the line's error and its own noise put it, in squares.
TEST(Posterior, PredictsFurtherObservations) {
    const IdentificationTask task = line();
    const Posterior p = sample_posterior(task, identify(task), {});
    const double sigma = std::hypot(1e5, 5 * 1e5 / std::sqrt(55));
    // Quantiles of 2.5 % of 400 points scatter by 0.13 sigma each.
    EXPECT_NEAR((p.predicted[4].high - p.predicted[4].low) / (2 * 1.96 * sigma), 1, .25);
}

// Without errors of the observations their deviation is told by the residuals: Student's t. Of five
// values with one parameter t_0.975(4) = 2.78.
TEST(Posterior, OfUnknownErrorsHasStudentsTails) {
    IdentificationTask task = line();
    task.tables[0].standard_errors.clear();
    const double noise[] = {1e5, -1e5, .5e5, -.5e5, 0};
    for (int i = 0; i < 5; ++i) task.tables[0].observed[i] += noise[i];
    const Identification found = identify(task);
    const Posterior p = sample_posterior(task, found, {});
    EXPECT_NEAR((p.interval[0].high - p.interval[0].low) /
                    (found.parameters[0].high - found.parameters[0].low),
                1, .2);
}

}  // namespace
}  // namespace tricontact::experiments::posterior_test
