// Contact lost under a prescribed depth, since a relaxing surface follows late, and found again.

#include "tests/verification/bem/lost_contact.h"

#include <array>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/run.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"

namespace tricontact::bem_lost_contact_test {
namespace {

using namespace lost_contact_test;

contact::Case rubber(double nu = .5) {
    contact::Case c;
    c.indenter.radius = .04;
    c.substrate = {4.5e6, nu};
    c.friction.coefficient = .5;
    c.of<contact::Cells>().per_radius = 12;
    return relaxing(c);
}

contact::Case layer() {
    contact::Case c = rubber(.4);
    c.layer.thickness = 8e-3;
    return c;
}

// What pressed is forgotten when it has relaxed: the force is that of a surface at rest.
TEST(LostContact, OfSprings) {
    const auto model = mdr::make_model(rubber());
    expect_lost_and_back(*model, 1e-9);
    expect_no_force_is_carried(*model);
}

TEST(LostContact, OfBoundaryElements) {
    const auto model = bem::make_model(rubber(), 1);
    EXPECT_FALSE(model->is_coupled());
    expect_lost_and_back(*model, 1e-6);
    expect_no_force_is_carried(*model);
}

// Friction keeps what pressures moved sideways, a thousandth of the force.
TEST(LostContact, OfCoupledBoundaryElements) {
    const auto model = bem::make_model(rubber(.3), 1);
    EXPECT_TRUE(model->is_coupled());
    expect_lost_and_back(*model, 1e-2);
    expect_no_force_is_carried(*model);
}

TEST(LostContact, OfTheLayer) {
    const auto model = bem::make_model(layer(), 1, bem::Body::layer);
    EXPECT_TRUE(model->is_coupled());
    expect_lost_and_back(*model, 1e-2);
    expect_no_force_is_carried(*model);
}

TEST(LostContact, OfTheLayersSprings) {
    const auto model = mdr::make_layer_model(layer());
    expect_lost_and_back(*model, 1e-6);
    expect_no_force_is_carried(*model);
}

// A path with shifts, which are no forces: friction has nothing to carry while the contact is lost.
TEST(LostContact, OnAPathOfShifts) {
    contact::Case c = rubber();
    contact::PrescribedPath path{std::vector<contact::PrescribedPath::Row>(6)};
    for (std::size_t k = 0; k < path.rows.size(); ++k) {
        auto& row = path.rows[k];
        row.time = std::array{0., 1., 11., 11.1, 13., 14.}[k];
        row.normal = {contact::NormalControl::Kind::indentation,
                      std::array{0., depth, depth, raised, raised, depth / 2}[k]};
        row.tangential[0] = {contact::TangentialControl::Kind::shift, 1e-5 * k};
        row.steps = 5;
    }
    c.prescribed_path = path;
    const auto springs = contact::run(c, *mdr::make_model(c));
    const auto cells = contact::run(c, *bem::make_model(c, 1));
    ASSERT_EQ(springs.steps.size(), cells.steps.size());
    double peak = 0;
    int lost = 0;
    for (const auto& step : springs.steps) peak = std::max(peak, step.normal_force);
    for (std::size_t k = 0; k < springs.steps.size(); ++k) {
        const auto &a = springs.steps[k], &b = cells.steps[k];
        EXPECT_NEAR(a.normal_force, b.normal_force, .005 * peak) << k;  // 12 cells in the radius
        EXPECT_EQ(a.shift[0], b.shift[0]) << k;
        lost += a.normal_force == 0 && b.normal_force == 0;
    }
    EXPECT_GE(lost, 3);
    EXPECT_GT(cells.steps.back().normal_force, .1 * peak);
}

}  // namespace
}  // namespace tricontact::bem_lost_contact_test
