#include "rolling/steady_error.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tricontact::rolling::steady_error_test {
namespace {

contact::Case braked_sphere() {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = .57;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .3;
    c.tractive_rolling.emplace();
    return c;
}

/// Off by a share of first order, creepage and stick alike.
RollingState state_off(double share) {
    return {.creepage = {.longitudinal = .01 * (1 + share)},
            .normal_force = 20,
            .indentation = 5e-4 * (1 + share),
            .force = {3.42, 0},
            .half_length = 4.4e-3,
            .half_width = 4.4e-3,
            .peak_pressure = 5e5 * (1 + share),
            .contact_area = 6e-5,
            .stick_area = 5e-5,
            .slip_area = 1e-5,
            .dissipation = .03};
}

SteadyError error_of(const std::string& model, const std::optional<RollingState>& coarsest,
                     double tolerance = 1e-7) {
    return steady_error(braked_sphere(), model, state_off(.01), state_off(.02), coarsest, tolerance,
                        2e-4);
}

// v_h - v is h's part of a first order: 1.25 times what separates two sizes covers it.
TEST(SteadyError, CoversErrorsOfTheFirstOrder) {
    const SteadyError error = error_of("bem", state_off(.04));
    EXPECT_NEAR(*error.of("longitudinal_creepage"), 1.25 * .01 * .01, 1e-12);
    EXPECT_NEAR(*error.of("indentation_m"), 1.25 * .01 * 5e-4, 1e-12);
    // Springs have no order: the coarser pair counts as it is; two sizes count three times.
    EXPECT_NEAR(*error_of("mdr", state_off(.04)).of("indentation_m"), 1.25 * .02 * 5e-4, 1e-12);
    EXPECT_NEAR(*error_of("bem", {}).of("indentation_m"), 3 * .01 * 5e-4, 1e-12);
}

// What the case prescribes is exact; where nothing changes the solver's tolerance is left, and of
// an area half a cell at its edge: 2 A/a times h/2.
TEST(SteadyError, IsNeverZeroOfWhatIsComputed) {
    const SteadyError error = error_of("bem", state_off(.04), 1e-6);
    EXPECT_FALSE(error.of("normal_force_N"));
    EXPECT_FALSE(error.of("force_ratio"));
    EXPECT_EQ(std::ranges::count(error.exact, "normal_force_N"), 1);
    EXPECT_NEAR(*error.of("contact_area_m2"), 6e-5 * 2e-4 / 4.4e-3, 1e-15);
    EXPECT_NEAR(*error.of("stick_share"), 2e-4 / 4.4e-3, 1e-15);
    EXPECT_NEAR(*error.of("half_length_m"), 1e-4, 1e-15);
    for (const auto& [key, width] : error.half_widths) EXPECT_GT(width, 0) << key;
}

}  // namespace
}  // namespace tricontact::rolling::steady_error_test
