// Bulk stress beside a tangential force: Nowell and Hills (1987) on loading and reversal, and what
// sticks as a whole on a ball.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bem/model.h"
#include "contact/base/bulk_state.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/load_path.h"
#include "contact/run.h"
#include "theory/bulk_stress_line.h"

namespace tricontact::bem::bulk_stress_test {
namespace {

using contact::Case;
constexpr double pi = std::numbers::pi, mu = .6;

/// Steel on steel, so long that its ends are not felt.
Case cylinder() {
    Case c;
    c.indenter.shape = Case::Shape::cylinder;
    c.indenter.radius = 10e-3;
    c.indenter.length = 1;
    c.indenter.material = c.substrate = contact::Material{206e9, .3};
    c.friction.coefficient = mu;
    c.load.normal_force = 2e5;
    c.of<contact::Cells>().per_radius = 40;
    return c;
}

theory::BulkStressLine exact(const Case& c, double ratio, double bulk) {
    return theory::bulk_stress_line(c.materials().effective_modulus(), c.substrate,
                                    c.indenter.radius, *c.load.normal_force / c.indenter.length, mu,
                                    ratio, bulk);
}

class Loaded {
  public:
    explicit Loaded(const Case& c) : case_(c), model_(make_model(c, 1)) {
        model_->advance(contact::press_step(c));
    }
    void load(double ratio, double bulk) {
        contact::LoadStep step = contact::press_step(case_);
        step.tangential[0].value = ratio * mu * *case_.load.normal_force;
        step.bulk = case_.bulk_state(bulk);
        model_->advance(step);
    }
    contact::Surface surface() const { return model_->surface(); }
    std::unique_ptr<const contact::Interior> interior() { return model_->interior(); }
    /// First moment of the traction over mu p0 a^2 [-].
    double moment() const {
        const contact::Surface s = surface();
        const auto line = exact(case_, .5, 0);
        double sum = 0;
        for (int i = 0; i < s.n_x; ++i) sum += s.x(i) * s.tangential_traction_x[i] * s.spacing[0];
        return sum / (mu * line.peak_pressure * std::pow(line.half_width, 2));
    }

  private:
    Case case_;
    std::unique_ptr<contact::Model> model_;
};

// Traction to the cells' size, the stick zone to a cell; the moment of the traction, to which its
// errors at the edges of the zones hardly add, to 1 %: -(pi/2) (c/a)^2 e/a.
TEST(BulkStress, MovesTheStickZoneAsNowellAndHillsHaveIt) {
    const Case c = cylinder();
    for (const auto& [ratio, share] : {std::pair(.6, .1), std::pair(.6, -.2), std::pair(-.5, .1)}) {
        const double bulk = share * 4 * mu * exact(c, ratio, 0).peak_pressure;
        const auto line = exact(c, ratio, bulk);
        ASSERT_TRUE(line.holds());
        Loaded loaded(c);
        loaded.load(ratio, bulk);
        const contact::Surface s = loaded.surface();
        double low = 1, high = -1, squares = 0;
        for (int i = 0; i < s.n_x; ++i) {
            if (s.contact_state[i] == contact::ContactState::stick) {
                low = std::min(low, s.x(i));
                high = std::max(high, s.x(i));
            }
            squares += std::pow(s.tangential_traction_x[i] - line.traction(s.x(i)), 2);
        }
        EXPECT_NEAR((low + high) / 2, line.stick_centre, s.spacing[0]);
        EXPECT_NEAR((high - low) / 2, line.stick_half_width, s.spacing[0]);
        EXPECT_LT(std::sqrt(squares / s.n_x), .02 * mu * line.peak_pressure);
        const double a = line.half_width, sign = ratio < 0 ? -1 : 1;
        EXPECT_NEAR(loaded.moment() / (-sign * pi / 2 * std::pow(line.stick_half_width / a, 2) *
                                       line.stick_centre / a),
                    1, .01);
    }
}

// From (F_T, sigma) to (-F_T, -sigma) in steps, in phase: what was there less twice the traction of
// half the change, with c' and e' of that.
TEST(BulkStress, Reversed) {
    const Case c = cylinder();
    const double ratio = .6, bulk = .1 * 4 * mu * exact(c, ratio, 0).peak_pressure;
    Loaded loaded(c);
    loaded.load(ratio, bulk);
    const double before = loaded.moment();
    for (const double level : {.5, 0., -.4}) {
        loaded.load(level * ratio, level * bulk);
        const double change = (1 - level) / 2;
        const auto half = exact(c, change * ratio, change * bulk);
        const double a = half.half_width;
        EXPECT_NEAR(loaded.moment(),
                    before + pi * std::pow(half.stick_half_width / a, 2) * half.stick_centre / a,
                    .002)
            << level;
    }
    // Fully reversed: the mirror image of the first loading.
    loaded.load(-ratio, -bulk);
    EXPECT_NEAR(loaded.moment() / -before, 1, 1e-3);
}

// nu = 0: tractions along x displace as pressures do, and a surface that is stretched by eps under
// a ball that does not slip carries what a punch tilted by eps has (Johnson 1985, eq. 3.36 on): ∫ x
// t dA = -(4/3) E* a^3 eps, G* = E* at nu = 0. At the rim something always slips: little of what mu
// = 100 bears. Of rows across, none: nu eps = 0.
TEST(BulkStress, StretchesABallThatSticks) {
    Case c = cylinder();
    c.indenter.shape = Case::Shape::paraboloid;
    c.load.normal_force = 200;
    c.indenter.material = c.substrate = contact::Material{100e9, 0};
    c.friction.coefficient = 100;
    c.load.tangential_force = 0;
    c.load.bulk_stress = 5e7;
    c.of<contact::Cells>().per_radius = 24;
    const auto model = make_model(c, 1);
    const auto path = contact::make_load_path(c, *c.load.normal_force, 1);
    for (const auto& step : path.pressing) model->advance(step);
    for (const auto& step : path.loading) model->advance(step);
    const contact::Surface s = model->surface();
    double moment = 0;
    for (std::size_t i = 0; i < s.size(); ++i)
        moment += s.x(static_cast<int>(i) % s.n_x) * s.tangential_traction_x[i] * s.spacing[0] *
                  s.spacing[1];
    const double a = contact::half_space_scales(c).contact_radius;
    // The edge is cut by cells: .5 % at a/24.
    EXPECT_NEAR(moment / (-4. / 3 * c.materials().effective_modulus() * a * a * a * 5e7 / 100e9), 1,
                .015);
    EXPECT_TRUE(model->audit().passed());
}

// Of a ball the circle that sticks moves by the strain over the gradient of the displacement under
// full sliding, pi mu p0 (4 - 3 nu)/(8 G a) of two equal bodies: exact at nu = 0, else nearly so.
TEST(BulkStress, MovesTheCircleThatSticksUnderABall) {
    for (const double nu : {0., .3}) {
        Case c = cylinder();
        c.indenter.shape = Case::Shape::paraboloid;
        c.indenter.material = c.substrate = contact::Material{206e9, nu};
        c.load.normal_force = 200;
        c.of<contact::Cells>().per_radius = 20;
        const auto hertz = contact::half_space_scales(c);
        const double gradient =
            pi * mu * hertz.peak_pressure * (4 - 3 * nu) / (8 * c.substrate.shear_modulus());
        Loaded loaded(c);
        loaded.load(.5, .1 * 206e9 * gradient);
        const contact::Surface s = loaded.surface();
        double n = 0, sum = 0;
        for (std::size_t i = 0; i < s.size(); ++i)
            if (s.contact_state[i] == contact::ContactState::stick) {
                ++n;
                sum += s.x(static_cast<int>(i) % s.n_x);
            }
        EXPECT_NEAR(sum / n / hertz.contact_radius, .1, nu == 0 ? .002 : .004);
    }
}

// Inside, at all points deeper than half a half width: closed forms to the cells' size, a/40, and
// far away the bulk stress alone.
TEST(BulkStress, IsInTheStressInside) {
    const Case c = cylinder();
    const double bulk = .1 * 4 * mu * exact(c, .6, 0).peak_pressure;
    const auto line = exact(c, .6, bulk);
    Loaded loaded(c);
    loaded.load(.6, bulk);
    const auto inside = loaded.interior();
    ASSERT_TRUE(inside);
    int n = 0;
    for (std::size_t i = 0; i < inside->size(); ++i) {
        const auto [x, y, z] = inside->position(i);
        if (std::abs(y) > .1 * c.indenter.length) continue;
        if (-z < .5 * line.half_width || -z > 2 * line.half_width) continue;
        const auto expected = line.stress(c.substrate, x, -z);
        for (const int k : {0, 1, 2})
            EXPECT_NEAR(inside->stress[i][k], expected[k], .01 * line.peak_pressure);
        // z out of the substrate.
        EXPECT_NEAR(inside->stress[i][5], -expected[5], .01 * line.peak_pressure);
        ++n;
    }
    EXPECT_GT(n, 20);
}

TEST(BulkState, IsUniaxialOrInPlaneStrain) {
    const contact::Material steel{200e9, .3};
    const auto along = contact::bulk_state(steel, 1e8, false), plane = bulk_state(steel, 1e8, true);
    EXPECT_EQ(along.strain, (std::array<double, 3>{5e-4, -.3 * 5e-4, -.3 * 5e-4}));
    EXPECT_DOUBLE_EQ(plane.strain[0], .91 * 5e-4);
    EXPECT_EQ(plane.strain[1], 0);
    EXPECT_DOUBLE_EQ(plane.stress[1], 3e7);
    // Hooke: e_zz = -nu (sigma_x + sigma_y)/E.
    EXPECT_DOUBLE_EQ(plane.strain[2], -.3 * 1.3e8 / 200e9);
}

}  // namespace
}  // namespace tricontact::bem::bulk_stress_test
