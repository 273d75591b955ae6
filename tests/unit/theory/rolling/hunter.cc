#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "theory/rolling/relaxing_rolling.h"

namespace tricontact::theory::hunter_test {
namespace {

constexpr double modulus = 3e6, radius = .07, force = 900, ratio = 2;

HunterContact at(double relaxation_way) {
    return hunter_contact({modulus, radius, ratio, relaxation_way}, force);
}

/// Hertz' half length on a half-space of this modulus [m].
double hertz(double effective_modulus) {
    return std::sqrt(4 * radius * force / (std::numbers::pi * effective_modulus));
}

// Slow: relaxed; fast: as stiff as at once. What is left is of the first order in the way over the
// length, and its inverse.
TEST(Hunter, SlowOrFastItIsHertz) {
    EXPECT_NEAR(at(1e-5 * hertz(modulus)).half_length / hertz(modulus), 1, 3e-5);
    EXPECT_NEAR(at(1e5 * hertz(modulus)).half_length / hertz((1 + ratio) * modulus), 1, 3e-5);
}

// The energy that a slow viscosity takes, derived without Hunter.
TEST(Hunter, SlowRollingResistsInProportionToTheSpeed) {
    const contact::Relaxation solid{{{ratio, .2}}};
    for (const double way : {1e-3, 5e-4}) {
        const double lead = at(way * hertz(modulus)).lead;
        const double slow = slow_resistance_ratio(solid, way * hertz(modulus) / .2, radius);
        EXPECT_NEAR(lead / radius / slow, 1, 5 * way) << way;
    }
}

// Fast: the lead falls again; in between some tenth of the contact.
TEST(Hunter, ResistsMostWhereARelaxationIsAboutAContactLong) {
    const double a = hertz(modulus);
    EXPECT_GT(at(.5 * a).lead, 5 * at(.02 * a).lead);
    EXPECT_GT(at(.5 * a).lead, 5 * at(50 * a).lead);
    EXPECT_GT(at(.5 * a).lead, .1 * a);
}

// Where the quotients of Bessel functions become series: second differences.
TEST(Hunter, HasNoStepWhereSeriesTakeOver) {
    const double way = hertz(modulus) / 100, step = 5e-3 * way;
    for (int k = -5; k <= 5; ++k) {
        const double middle = way + k * step, lead = at(middle).lead;
        EXPECT_NEAR(at(middle - step).lead - 2 * lead + at(middle + step).lead, 0, 2e-6 * lead);
    }
}

TEST(Hunter, RefusesWhatIsNotPositive) {
    EXPECT_THROW(at(0), std::domain_error);
    EXPECT_THROW(hunter_contact({modulus, radius, ratio, 1e-3}, -1), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::hunter_test
