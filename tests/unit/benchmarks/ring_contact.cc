// What an interface changes of a contact, beside the envelope theorem and exact contacts.
#include "benchmarks/reference/ring_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "benchmarks/reference/radial_contact.h"
#include "tests/unit/benchmarks/foreign.h"

namespace tricontact::benchmarks {
namespace ring_contact {

const contact::NormalControl depth{contact::NormalControl::Kind::indentation, .35e-3};

// The rings' edges are h = a/100 apart: force and centre to h^2.
TEST(RingContact, IsTheExactContact) {
    const contact::Case& c = foreign::layer_pressed().c;
    const RadialContact exact(c, depth);
    const RingContact rings(c, exact.radius(), 100);
    const auto state = rings.solve(depth, {});
    ASSERT_TRUE(state);
    EXPECT_NEAR(state->force / exact.force(), 1, 1e-4);
    EXPECT_NEAR(state->pressure[0] / exact.pressure(0), 1, 1e-4);
}

// Forces beside FreeFem++ 4.11, P2, with penalties of 26 and 260 MPa/mm: -4.03 and -.401 %, the
// latter with what its mesh leaves; and beside the envelope theorem, second order in the slope.
TEST(RingContact, ForcesAreThoseOfCodes) {
    const Reference& reference = foreign::layer_pressed();
    const RingContact rings(reference.c, reference.contact_radius, 100);
    const double force = rings.solve(depth, {})->force;
    const auto change = [&](const InterfaceLaw& law) {
        return rings.solve(depth, law)->force / force - 1;
    };
    EXPECT_NEAR(change({.compliance = 1 / 26e9}), -.0403, .0002);
    EXPECT_NEAR(change({.compliance = 1 / 260e9}), -.00401, .0003);
    const double first_order = reference.effects.displaced_surface->value / force;
    EXPECT_NEAR(change({.is_displaced = true}), first_order, .03 * first_order);
}

}  // namespace ring_contact
}  // namespace tricontact::benchmarks
