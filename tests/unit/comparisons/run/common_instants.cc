#include "comparisons/run/common_instants.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tricontact::comparisons::common_instants_test {
namespace {

using report::Film;
using Part = Film::Part;

/// A run that is judged after `periods`, of which every `kept`-th of n steps is kept, from the end.
Film run_of(const std::string& name, int periods, int n, int kept) {
    Film film{.name = name};
    film.frames.push_back({.label = "pressed", .part = Part::pressed});
    film.frames.push_back({.label = "loaded", .part = Part::loaded});
    for (const int period : {1, periods}) {
        for (int k = 1; k <= n; ++k)
            if ((n - k) % kept == 0)
                film.frames.push_back({.label = fmt::format("n = {:.4g}", period - 1 + 1. * k / n),
                                       .part = period == 1 ? Part::first_period : Part::last_period,
                                       .phase = 1. * k / n + 1e-12 * period});
        if (periods == 1) break;
    }
    return film;
}

// What was found in the demo: MDR is judged after 13 periods, BEM after 20. By labels, MDR alone
// moved in its last period. At each instant all stand at the same share of a period.
TEST(CommonInstants, AllModelsStandAtTheSameShareOfThePeriod) {
    const std::vector<Film> films{run_of("MDR", 13, 24, 1), run_of("MDR layer", 14, 24, 2),
                                  run_of("BEM", 20, 24, 3)};
    const auto instants = common_instants(films);
    ASSERT_EQ(instants.size(), 2u + 4 + 4);  // 24 steps in common steps of 6
    int n_last = 0;
    for (const auto& [label, frames] : instants) {
        ASSERT_EQ(frames.size(), films.size());
        const Film::Frame& first = films[0].frames[static_cast<std::size_t>(frames[0])];
        for (std::size_t i = 0; i < films.size(); ++i) {
            const Film::Frame& own = films[i].frames[static_cast<std::size_t>(frames[i])];
            EXPECT_EQ(own.part, first.part);
            EXPECT_NEAR(own.phase, first.phase, 1e-9);
        }
        // n stands in the headline as long as it is that of all.
        EXPECT_EQ(label.starts_with("n = "), first.part == Part::first_period) << label;
        n_last += first.part == Part::last_period;
    }
    EXPECT_EQ(n_last, 4);
    const auto& [label, frames] = instants.back();
    EXPECT_EQ(label, "end of each model's last period");
    EXPECT_EQ(films[0].frames[static_cast<std::size_t>(frames[0])].label, "n = 13");
    EXPECT_EQ(films[2].frames[static_cast<std::size_t>(frames[2])].label, "n = 20");
}

TEST(CommonInstants, AModelAloneKeepsAllOfItsInstants) {
    const Film film = run_of("BEM", 5, 8, 1);
    const auto instants = common_instants({film});
    ASSERT_EQ(instants.size(), film.frames.size());
    for (std::size_t k = 0; k < instants.size(); ++k)
        EXPECT_EQ(instants[k].label, film.frames[k].label);
}

// The first period of a run that ends with it is its last one, too.
TEST(CommonInstants, ARunOfOnePeriodHasItAsItsLast) {
    const std::vector<Film> films{run_of("MDR", 1, 4, 1), run_of("BEM", 3, 4, 1)};
    const auto instants = common_instants(films);
    ASSERT_EQ(instants.size(), 2u + 4 + 4);
    EXPECT_EQ(films[0].frames[static_cast<std::size_t>(instants.back().frames[0])].label, "n = 1");
    EXPECT_EQ(films[1].frames[static_cast<std::size_t>(instants.back().frames[1])].label, "n = 3");
}

// A model without a loaded instant says so by -1; the others go on.
TEST(CommonInstants, WhatAModelLacksIsNotReplaced) {
    Film film = run_of("MDR", 2, 4, 1);
    std::erase_if(film.frames, [](const Film::Frame& f) { return f.part == Part::loaded; });
    const auto instants = common_instants({film, run_of("BEM", 2, 4, 1)});
    ASSERT_EQ(instants.size(), 2u + 4 + 4);
    EXPECT_EQ(instants[1].label, "loaded");
    EXPECT_EQ(instants[1].frames, (std::vector<int>{-1, 1}));
}

// One scale for all: its end is the largest value of any film.
TEST(CommonInstants, TheScaleEndsAtTheLargestOfAll) {
    Film a, b;
    a.largest = {3e5, 1e5, 2e-6, 0}, b.largest = {1e5, 4e5, 1e-6, 5e6};
    const auto largest = largest_of({a, b});
    EXPECT_EQ(largest[0], "300 kPa");
    EXPECT_EQ(largest[1], "400 kPa");
    EXPECT_EQ(largest[2], "2.00 µm");
    EXPECT_EQ(largest[3], "5.00 MPa");
}

}  // namespace
}  // namespace tricontact::comparisons::common_instants_test
