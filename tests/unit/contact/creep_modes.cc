#include "contact/creep_modes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::contact::creep_modes_test {
namespace {

constexpr double cell = .3, compliance = .7, relaxed = 1.3;

/// Displacements at n cells from `distance` back, of a field w(x).
template <class Field>
std::vector<double> crept(const Field& w, double length, double distance, int n) {
    Retardation mode({}, 0);
    mode.relaxed = relaxed;
    mode.branches = {{compliance, length / 2}};
    const CreepAlongWay creep({mode}, 2, cell, distance);
    std::vector<double> cells, ahead, sum(n);
    for (int k = 0; k < n; ++k) cells.push_back(w(distance - k * cell));
    for (const double s : creep.ahead()) ahead.push_back(w(distance + s));
    creep.add(0, cells, ahead, sum);
    return sum;
}

// Over a wave of the length b: (1/l) int exp(-s/l) exp(-(x + s)/b) ds = exp(-x/b)/(1 + l/b).
TEST(CreepAlongWay, OfAWaveIsExactAheadAndOfTheSecondOrderBehind) {
    const double b = 40 * cell, distance = 30 * cell;
    const auto wave = [&](double x) { return std::exp(-x / b); };
    for (const double length : {.2 * cell, 3 * cell, 500 * cell}) {
        const auto u = crept(wave, length, distance, 60);
        const double factor = relaxed - compliance * (1 - 1 / (1 + length / b));
        EXPECT_NEAR(u[0] / wave(distance), factor, 1e-11) << length;
        // (h/b)^2/12 of the creep, with w linear between cells.
        for (int k = 0; k < 60; ++k)
            EXPECT_NEAR(u[k] / wave(distance - k * cell), factor, 1e-4) << length;
    }
}

// What a load displaces far ahead falls as 1/x: an exponential integral, whatever the way over the
// distance.
TEST(CreepAlongWay, RemembersWhatLiesFarAhead) {
    const double distance = 30 * cell;
    for (const double length : {.02 * distance, .5 * distance, 20 * distance, 1e4 * distance}) {
        const double z = distance / length;
        const double mean = std::exp(z) * -std::expint(-z) / length;
        const double exact = relaxed / distance - compliance * (1 / distance - mean);
        EXPECT_NEAR(crept([](double x) { return 1 / x; }, length, distance, 1)[0] / exact, 1, 1e-10)
            << length;
    }
}

TEST(CreepAlongWay, AtRestAllHasRelaxed) {
    EXPECT_EQ(crept([](double x) { return 2 * x; }, 0, 1, 2),
              (std::vector<double>{2 * relaxed, 2 * relaxed * (1 - cell)}));
}

}  // namespace
}  // namespace tricontact::contact::creep_modes_test
