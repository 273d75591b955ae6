#include "contact/prescribed_path.h"

#include <gtest/gtest.h>

#include <numbers>

#include "contact/base/error.h"
#include "contact/load_path.h"

namespace tricontact::prescribed_path_test {
namespace {

using contact::NormalControl;
using contact::PrescribedPath;
using contact::TangentialControl;

PrescribedPath::Row row(double normal, double tangential, int steps = 1) {
    PrescribedPath::Row row;
    row.normal.value = normal;
    row.tangential[0].value = tangential;
    row.steps = steps;
    return row;
}

contact::Case with(PrescribedPath path) {
    contact::Case c;
    c.friction.coefficient = .5;
    c.load.normal_force = path.hardest_normal().value;
    c.load.tangential_force = 0;
    c.prescribed_path = std::move(path);
    return c;
}

TEST(PrescribedPath, EndsExactlyAtItsRows) {
    const auto from = row(.1, .3), to = row(.7, -.9);
    const auto end = PrescribedPath::between(from, to, 1);
    EXPECT_EQ(end.normal.value, .7);
    EXPECT_EQ(end.tangential[0].value, -.9);
    EXPECT_DOUBLE_EQ(PrescribedPath::between(from, to, .5).normal.value, .4);
}

TEST(PrescribedPath, IsALineOfItsFarthestOffset) {
    PrescribedPath path{{row(1, 0), row(1, 0), row(1, 0)}};
    path.rows[1].offset = {-1, -1};
    path.rows[2].offset = {.5, .5};
    EXPECT_NEAR(path.direction(), -.75 * std::numbers::pi, 1e-15);
    EXPECT_EQ(path.reach(), (contact::Vector2{1, 1}));
    EXPECT_FALSE(path.is_along_x());
}

TEST(PrescribedPath, IsSymmetricUnlessSomethingIsAcross) {
    PrescribedPath path{{row(1, 0), row(1, .2)}};
    path.rows[1].offset = {1, 0};
    EXPECT_TRUE(path.is_along_x());
    path.rows[1].rotation = 1e-3;
    EXPECT_FALSE(path.is_along_x());
    path.rows[1].rotation = 0;
    path.rows[1].tangential[1].value = .1;
    EXPECT_FALSE(path.is_along_x());
}

// The first row is reached by pressing, all in proportion; phases count rows.
TEST(PrescribedPath, BecomesALoadPath) {
    contact::Case c = with({{row(2, .4), row(3, .1, 2)}});
    c.load.press_steps = 4;
    const contact::LoadPath path = contact::make_load_path(c, 3, 1);
    ASSERT_EQ(path.pressing.size(), 4U);
    EXPECT_EQ(path.pressing[1].normal.value, 1);
    EXPECT_DOUBLE_EQ(path.pressing[1].tangential[0].value, .2);
    ASSERT_EQ(path.loading.size(), 2U);
    EXPECT_EQ(path.loading[0].phase, .5);
    EXPECT_DOUBLE_EQ(path.loading[0].normal.value, 2.5);
    EXPECT_EQ(path.loading[1].phase, 1);
    EXPECT_TRUE(path.period.empty());
}

// Pressed without friction first, loaded then.
TEST(PrescribedPath, LoadsItsFirstRowAfterFrictionlessPressing) {
    contact::Case c = with({{row(2, .4), row(3, .1)}});
    c.load.press = contact::Case::Press::frictionless;
    const contact::LoadPath path = contact::make_load_path(c, 3, 1);
    ASSERT_EQ(path.pressing.size(), 1U);
    EXPECT_EQ(path.pressing[0].tangential[0].value, 0);
    EXPECT_FALSE(path.pressing[0].friction);
    ASSERT_EQ(path.loading.size(), 2U);
    EXPECT_EQ(path.loading[0].tangential[0].value, .4);
    EXPECT_TRUE(path.loading[0].friction);
}

// A first row without load is where the indenter touches.
TEST(PrescribedPath, BeginsUnloadedWithoutPressing) {
    const contact::LoadPath path = contact::make_load_path(with({{row(0, 0), row(3, 1, 3)}}), 3, 1);
    EXPECT_TRUE(path.pressing.empty());
    EXPECT_EQ(path.loading.size(), 3U);
    EXPECT_EQ(path.loading[0].normal.value, 1);
}

TEST(PrescribedPath, IsRefusedWhereFrictionDoesNotCarryIt) {
    EXPECT_THROW(contact::make_load_path(with({{row(2, 0), row(2, 1)}}), 3, 1),
                 contact::InputError);
    EXPECT_NO_THROW(contact::make_load_path(with({{row(2, 0), row(2, .99)}}), 3, 1));
}

}  // namespace
}  // namespace tricontact::prescribed_path_test
