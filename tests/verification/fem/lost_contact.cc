// Contact of finite elements that is lost under a prescribed depth and found again.

#include "tests/verification/bem/lost_contact.h"

#include "tests/verification/fem/rig.h"

namespace tricontact::fem::fem_lost_contact_test {
namespace {

using namespace lost_contact_test;

TEST(FemLostContact, ComesBack) {
    const auto model = make_layer_model(relaxing(layer_case(1.5e-3, .4)));
    expect_lost_and_back(*model, 2e-2);
    expect_no_force_is_carried(*model);
}

}  // namespace
}  // namespace tricontact::fem::fem_lost_contact_test
