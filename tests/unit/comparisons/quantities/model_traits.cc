#include "comparisons/quantities/model_traits.h"

#include <gtest/gtest.h>

#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::model_traits_test {
namespace {

std::string taken_for_granted(const contact::Case& c, const std::string& model) {
    return names_of(traits_of(c, model) & ~uncoupled);
}

// Whoever does not mesh the body takes a half-space in its place; without a body nobody does.
TEST(ModelTraits, AnIndenterWithABodyIsNoHalfSpace) {
    contact::Case c = synthetic::unit_case();
    EXPECT_EQ(taken_for_granted(c, "bem"), "");
    c.indenter.body = contact::ElasticBody{};
    EXPECT_EQ(taken_for_granted(c, "bem"), "indenter as half-space");
    EXPECT_EQ(taken_for_granted(c, "mdr"), "springs on a line, indenter as half-space");
    EXPECT_EQ(taken_for_granted(c, "fem"), "");
    EXPECT_EQ(taken_for_granted(c, "fem-axisymmetric"), "");
    c.layer.thickness = 1;
    EXPECT_EQ(taken_for_granted(c, "bem"), "half-space, indenter as half-space");
    EXPECT_EQ(taken_for_granted(c, "bem-layer"), "indenter as half-space");
}

}  // namespace
}  // namespace tricontact::comparisons::model_traits_test
