// Contact of finite elements that is lost under a prescribed depth and found again.

#include "tests/verification/bem/lost_contact.h"

#include <limits>

#include "tests/verification/fem/rig.h"

namespace tricontact::fem::fem_lost_contact_test {
namespace {

using namespace lost_contact_test;

TEST(FemLostContact, ComesBack) {
    const auto model = make_layer_model(relaxing(layer_case(1.5e-3, .4)));
    expect_lost_and_back(*model, 2e-2);
    expect_no_force_is_carried(*model);
}

// The body that nothing touches is in balance without tractions to compare its forces with.
TEST(FemLostContact, ComesBackAtFiniteStrains) {
    contact::Case c = relaxing(layer_case(2e-3));
    c.law = contact::Case::Law::neo_hookean;
    const auto model = make_layer_model(c);
    constexpr double forever = std::numeric_limits<double>::infinity();
    const double untouched = model->advance(at_depth(raised, forever)).normal_force;
    model->release();
    for (int k = 1; k <= 4; ++k) model->advance(at_depth(depth * k / 4, tau));
    model->advance(at_depth(depth, forever));
    for (int k = 1; k <= 4; ++k) model->advance(at_depth(depth + (raised - depth) * k / 4, 1e-4));
    const auto lost = model->advance(at_depth(raised, .1, 1e-6));
    EXPECT_EQ(lost.normal_force, 0);
    EXPECT_EQ(lost.contact_area, 0);
    EXPECT_EQ(lost.shift[0], 1e-6);
    const auto back = model->advance(at_depth(raised, forever, 1e-6));
    // Friction keeps what pressures moved sideways.
    EXPECT_NEAR(back.normal_force / untouched, 1, .02);
    EXPECT_TRUE(model->audit().passed());
}

}  // namespace
}  // namespace tricontact::fem::fem_lost_contact_test
