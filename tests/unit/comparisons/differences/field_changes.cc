// Half widths of fields over levels, of made-up errors of a known order and beside Hertz.
#include "comparisons/differences/field_changes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "app/models/make_model.h"
#include "contact/cells.h"
#include "mdr/settings.h"

namespace tricontact::field_changes_test {
namespace {

using comparisons::RefinedField;
using contact::Case;
using contact::Snapshot;
using contact::Surface;

constexpr int n_made = 10;

/// p = 1 + factor on a grid of its own spacing that does not matter: all have the same.
Snapshot made(double factor, double phase = 0) {
    Surface s;
    s.layout = Surface::Layout::grid;
    s.n_x = s.n_y = n_made;
    s.spacing = {1e-3, 1e-3};
    s.normal_traction.assign(std::size_t{n_made} * n_made, 1 + factor);
    return {.phase = phase, .surface = s};
}

std::vector<std::optional<Snapshot>> levels(double error, double order) {
    std::vector<std::optional<Snapshot>> all;
    for (const double h : {4., 2., 1.}) all.emplace_back(made(error * std::pow(h, order)));
    return all;
}

TEST(RefinedFields, OrderAndHalfWidthOfErrorsMadeUp) {
    constexpr double error = .01;
    const auto first = comparisons::refined_fields({4, 2, 1}, levels(error, 1), made(.03));
    ASSERT_EQ(first.size(), 1U);  // the others are nowhere
    EXPECT_EQ(first[0].field, "normal_traction");
    EXPECT_NEAR(first[0].order.value(), 1, .02);
    EXPECT_NEAR(first[0].changes[1], error / (1 + error), 1e-12);
    // 1.25 times the error itself, relative to the field.
    EXPECT_NEAR(first[0].error_l2, 1.25 * error / (1 + error), 1e-3 * error);
    EXPECT_NEAR(first[0].error_largest, 1.25 * error / (std::sqrt(2.) - 1) * 2 / std::sqrt(2.),
                1e-3 * error);
    EXPECT_NEAR(first[0].wide.value(), .01 / 1.02, 1e-12);
    // A higher order is not counted on; the error of a lower one is larger than twice the change.
    const auto second = comparisons::refined_fields({4, 2, 1}, levels(error, 2), {});
    EXPECT_GT(second[0].error_l2, 1.25 * error);
    EXPECT_FALSE(second[0].wide);
}

TEST(RefinedFields, NoneOfOtherInstantsOrTwoLevels) {
    auto other = levels(.01, 1);
    other[0]->phase = .25;
    EXPECT_TRUE(comparisons::refined_fields({4, 2, 1}, other, {}).empty());
    other[0].reset();
    EXPECT_TRUE(comparisons::refined_fields({4, 2, 1}, other, {}).empty());
    EXPECT_TRUE(comparisons::refined_fields({2, 1}, {made(.1), made(.2)}, {}).empty());
}

Case pressed(const char* model, double force, double cells) {
    Case c;
    c.models = {model};
    c.indenter.radius = .04;
    c.substrate = {5.2e6, 0};
    c.friction.coefficient = .57;
    c.contact.coupling = false;
    c.load.press = Case::Press::frictionless;
    c.load.normal_force = force;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().per_radius = cells;
    c.of<mdr::Settings>().springs = static_cast<int>(8 * cells);
    return c;
}

/// L2 norm of what a surface is off Hertz' pressure (Johnson 1985, eqs. 4.22 to 4.24).
double miss_of_hertz(const Surface& s, double force) {
    const double a = std::cbrt(3 * force * .04 / (4 * 5.2e6));
    const double p0 = 3 * force / (2 * std::numbers::pi * a * a);
    double apart2 = 0, own2 = 0;
    for (int j = 0; j < s.n_y; ++j)
        for (int i = 0; i < s.n_x; ++i) {
            const double x = s.x(i), r = std::hypot(x, s.n_y > 1 ? s.y(j) : 0);
            const double exact = r < a ? p0 * std::sqrt(1 - r * r / (a * a)) : 0;
            const double weight = s.n_y > 1 ? 1 : std::abs(x);  // springs stand for rings
            const double apart = s.normal_traction[static_cast<std::size_t>(j) * s.n_x + i] - exact;
            apart2 += weight * apart * apart;
            own2 += weight * exact * exact;
        }
    return std::sqrt(apart2 / own2);
}

// Boundary elements and springs, forces and cells at random.
TEST(RefinedFields, CoverThePressureOfHertz) {
    const contact::ModelRunner runner(app::model_makers(), 1);
    std::mt19937 random(48);
    std::uniform_real_distribution<> logarithm(-1, 1), cells(6, 14);
    for (int k = 0; k < 16; ++k) {
        const char* model = k % 2 ? contact::models::mdr : contact::models::bem;
        const double force = 20 * std::exp(logarithm(random)), per_radius = cells(random);
        SCOPED_TRACE(testing::Message() << model << ' ' << force << " N, " << per_radius);
        std::vector<double> sizes;
        std::vector<std::optional<Snapshot>> states;
        for (const double finer : {1., std::sqrt(2.), 2.}) {
            sizes.push_back(1 / std::round(8 * per_radius * finer));
            states.emplace_back(runner.history_of(model, pressed(model, force, per_radius * finer))
                                    .snapshots.back());
        }
        const auto fields = comparisons::refined_fields(sizes, states, {});
        ASSERT_FALSE(fields.empty());
        const double miss = miss_of_hertz(states.back()->surface, force);
        EXPECT_LE(miss, fields[0].error_l2);
        // One that is far too wide covers, too. Springs are nearer to Hertz than they are to each
        // other between their places.
        EXPECT_GT(miss, (k % 2 ? .005 : .02) * fields[0].error_l2);
        EXPECT_LT(fields[0].error_l2, k % 2 ? .06 : .2);
    }
}

}  // namespace
}  // namespace tricontact::field_changes_test
