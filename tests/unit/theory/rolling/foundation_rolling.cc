#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "theory/rolling/relaxing_rolling.h"

namespace tricontact::theory::foundation_rolling_test {
namespace {

constexpr double stiffness = 4e8, radius = .07, edge = 3e-3;
const contact::Relaxation prony{{{1.2, .05}, {.4, .3}}};

FoundationContact at(double speed) {
    return foundation_contact({prony, speed, stiffness, radius}, edge);
}

/// Force and lead of one spring stepped through the contact, exact for deflections that are linear
/// in a step.
std::pair<double, double> stepped(double speed, int n) {
    const double h = edge / n;
    const contact::RelaxationStep step(prony, h / speed);
    std::vector<double> memory(prony.branches.size());
    double force = 0, moment = 0, deflection = 0;
    for (int i = 1; i <= 2 * n; ++i) {
        const double x = edge - i * h, next = (edge - x) * (edge + x) / (2 * radius);
        double p = next;
        for (std::size_t b = 0; b < memory.size(); ++b) {
            memory[b] = step.decay[b] * memory[b] + step.gain[b] * (next - deflection);
            p += memory[b];
        }
        deflection = next;
        if (p < 0) break;
        force += stiffness * p * h;
        moment += stiffness * p * x * h;
    }
    return {force, moment / force};
}

// Second order in the step.
TEST(FoundationRolling, IsWhatASpringDoesStepByStep) {
    for (const double speed : {3e-3, .05, .4}) {
        const auto [force, lead] = stepped(speed, 20000);
        EXPECT_NEAR(at(speed).force / force, 1, 1e-6) << speed;
        EXPECT_NEAR(at(speed).lead / lead, 1, 1e-5) << speed;
    }
}

// Elastic: F = 2/3 k a^3/R, as long behind as ahead.
TEST(FoundationRolling, SlowItIsElastic) {
    const FoundationContact slow = at(1e-7);
    EXPECT_NEAR(slow.force / (2. / 3 * stiffness * std::pow(edge, 3) / radius), 1, 1e-4);
    EXPECT_NEAR(slow.trailing_edge / edge, -1, 1e-4);
    EXPECT_NEAR(slow.lead / radius / slow_resistance_ratio(prony, 1e-7, radius), 1, 1e-3);
}

TEST(FoundationRolling, IsFoundByItsForce) {
    for (const double speed : {1e-4, .02, 5.}) {
        const FoundationContact given = at(speed);
        const FoundationContact found =
            foundation_contact_under({prony, speed, stiffness, radius}, given.force);
        EXPECT_NEAR(found.leading_edge / edge, 1, 1e-9) << speed;
        EXPECT_NEAR(found.lead / given.lead, 1, 1e-8) << speed;
    }
}

// The plane profile is twice as steep as the body: springs resist slow rolling twice as much as the
// half-space.
TEST(FoundationRolling, OfMdrResistsTwiceAsMuchAsTheHalfSpace) {
    const FoundationRolling bed = mdr_foundation(prony, 1e-6, 5e6, radius);
    const FoundationContact contact = foundation_contact_under(bed, 20);
    EXPECT_NEAR(contact.lead / bed.radius / slow_resistance_ratio(prony, 1e-6, radius), 2, 1e-3);
    // Hertz: F = 4/3 E* a^3/R.
    EXPECT_NEAR(4. / 3 * 5e6 * std::pow(contact.leading_edge, 3) / radius / 20, 1, 1e-3);
}

TEST(FoundationRolling, RefusesWhatIsNotPositive) {
    EXPECT_THROW(at(0), std::domain_error);
    EXPECT_THROW(foundation_contact_under({prony, 1, stiffness, radius}, 0), std::domain_error);
}

}  // namespace
}  // namespace tricontact::theory::foundation_rolling_test
