#include "report/lazy_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tricontact::report::lazy_table_test {
namespace {

double cubic(double x, double z) {
    return 2 - x + .3 * x * x * x + z * (1 + x * x) - .1 * z * z * z;
}

TEST(LazyTable, IsExactForCubicsAndComputesWhatItNeeds) {
    int n = 0;
    LazyTable table(
        [&](double x, double z) {
            ++n;
            return std::vector<double>{cubic(x, z), 7};
        },
        .3, .1, {1, 9});
    for (const double x : {-.7, 0., 1.234})
        for (const double z : {.02, .35, .5, .99}) {  // beyond the rows, too
            EXPECT_NEAR(table.at(x, z)[0], cubic(x, z), 1e-12);
            EXPECT_NEAR(table.at(x, z)[1], 7, 1e-12);
        }
    const int before = n;
    table.at(1.23, .36);
    EXPECT_EQ(n, before);
    EXPECT_EQ(table.n_nodes(), static_cast<std::size_t>(n));
}

TEST(LazyTable, OfOneRowDependsOnOneVariable) {
    LazyTable table([](double x, double) { return std::vector<double>{std::exp(x)}; }, .1, .1,
                    {5, 5});
    EXPECT_NEAR(table.at(.25, .1)[0] / std::exp(.25), 1, 5e-6);  // 3/128 step^4
    EXPECT_EQ(table.n_nodes(), 4U);
    EXPECT_THROW(LazyTable({}, .1, .1, {1, 3}), std::invalid_argument);
}

TEST(LazyTable, ConvergesWithTheFourthPowerOfItsStep) {
    const auto worst = [](double step) {
        LazyTable table([](double x, double) { return std::vector<double>{std::sin(x)}; }, step, 1,
                        {0, 0});
        double error = 0;
        for (double x = 1; x < 4; x += .0137)
            error = std::max(error, std::abs(table.at(x, 0)[0] - std::sin(x)));
        return error;
    };
    EXPECT_NEAR(std::log2(worst(.2) / worst(.1)), 4, .1);
    EXPECT_NEAR(std::log2(worst(.1) / worst(.05)), 4, .1);
}

}  // namespace
}  // namespace tricontact::report::lazy_table_test
