// A layer between the surfaces that yields and hardens, under a contact that rolls back and forth
// over it: each point of the substrate keeps what its layer has flowed.
//   soft springs  each point alone, by hand, step by step;
//   limits        no hardening: a limit of strength; no flow: Coulomb's law;
//   path          the same motion by [path];
//   shakedown     where a limit of strength ratchets, what hardens comes to rest.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bem/model.h"
#include "contact/cells.h"
#include "contact/prescribed_path.h"
#include "contact/run.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::hardening_rolled_test {
namespace {

using contact::Case;
using contact::History;
using contact::InterfaceYield;
using contact::State;

/// The rig without coupling, n cells in a.
Case rolled(double w, double f, int periods, double cells_per_radius) {
    Case c = rig_case(w, f, periods);
    c.substrate.poisson = .3;
    c.indenter.material.reset();
    c.contact.coupling = false;
    c.of<contact::Cells>().spacing = 4.45e-3 / cells_per_radius;
    return c;
}

/// On springs much softer than the body, pressed by `depth`.
constexpr double depth = 3e-4;
Case on_soft_springs(double w) {
    Case c = rolled(w, .3, 4, 1);
    c.load.normal_force.reset();
    c.load.indentation = depth;
    const double a = std::sqrt(2 * c.indenter.radius * depth);
    c.rolling->amplitude_ratio.reset();
    c.rolling->amplitude = w * a;
    c.of<contact::Cells>().spacing = a / 40;
    c.interface.normal_stiffness = 1e-4 * c.materials().effective_modulus() / a;
    c.interface.tangential_stiffness = .7 * *c.interface.normal_stiffness;
    return c;
}

/// Points of a layer, each alone, that follow the indenter of a run.
class PointsAlone {
  public:
    PointsAlone(const Case& c, double spacing) : c_(c), spacing_(spacing) {
        const double reach = std::sqrt(2 * c.indenter.radius * depth) + *c.rolling->amplitude;
        n_ = 2 * static_cast<int>(reach / spacing) + 3;
        points_.resize(static_cast<std::size_t>(n_) * n_);
    }
    /// Forces on the substrate, and what friction and flow dissipate.
    std::pair<double, double> step(const contact::Vector2& offset, double moved) {
        const double K = *c_.interface.tangential_stiffness, area = spacing_ * spacing_;
        double force = 0, work = 0;
        for (int i = 0; i < n_; ++i)
            for (int j = 0; j < n_; ++j) {
                Point& point = points_[static_cast<std::size_t>(i) * n_ + j];
                const double x = (i - n_ / 2) * spacing_ - offset[0];
                const double y = (j - n_ / 2) * spacing_ - offset[1];
                const double gap = (x * x + y * y) / (2 * c_.indenter.radius) - depth;
                const double p = std::max(0., -gap * *c_.interface.normal_stiffness);
                const double slides = *c_.friction.coefficient * p;
                const double trial = point.t + K * moved;
                const double sign = trial > 0 ? 1 : -1;
                double left = std::abs(trial);
                if (p > 0 && left > point.strength && point.strength < slides) {  // flows
                    const double k = c_.friction.yield->hardening;
                    const double u =
                        std::min((left - point.strength) / (K + k), (slides - point.strength) / k);
                    work += area * u * (point.strength + k * u / 2);
                    point.strength += k * u;
                    left -= K * u;
                }
                if (left > slides) {
                    work += area * slides * (left - slides) / K;
                    left = slides;
                }
                point.t = sign * left;
                force += area * point.t;
            }
        return {force, work};
    }
    void yield_at(double stress) {
        for (Point& point : points_) point.strength = stress;
    }

  private:
    struct Point {
        double t = 0, strength = 0;
    };
    const Case& c_;
    double spacing_;
    int n_;
    std::vector<Point> points_;
};

// Cells of a/40 cut the rim, where p = 0, and bodies add 1e-4 of the softness: see interface.cc.
TEST(BemHardeningRolled, PointsOnSoftSpringsKeepWhatFlowed) {
    Case c = on_soft_springs(.25);
    const double peak = *c.interface.normal_stiffness * depth;
    c.friction.yield = InterfaceYield{.15 * *c.friction.coefficient * peak,
                                      .2 * *c.interface.tangential_stiffness};
    const History h = run_bem(c);
    PointsAlone points(c, c.of<contact::Cells>().spacing.value());
    points.yield_at(c.friction.yield->stress);
    double before = 0, work = 0, expected_work = 0;
    const double scale = h.friction_limit;
    for (const auto& step : h.steps) {
        const auto [force, taken] = points.step(step.offset, step.shift[0] - before);
        before = step.shift[0];
        EXPECT_NEAR((force - step.tangential_force[0]) / scale, 0, 2e-3) << step.phase;
        work += step.dissipation;
        expected_work += taken;
    }
    EXPECT_NEAR(work / expected_work, 1, 5e-3);
    // A layer that forgets would carry F_T at another shift.
    EXPECT_GT(h.shift_per_period.back(), 1.02 * h.static_shift);
}

TEST(BemHardeningRolled, LimitsAreAStrengthLimitAndNone) {
    for (const bool coupled : {false, true}) {
        Case c = rolled(.2, .5, 3, 10);
        c.contact.coupling = coupled;
        constexpr double stress = 1e5;
        Case soft = c, stiff = c, capped = c;
        soft.friction.yield = InterfaceYield{stress, 10};
        stiff.friction.yield = InterfaceYield{stress, 1e17};
        capped.friction.strength_limit = stress;
        const History coulombs = run_bem(c);
        capped.load.tangential_ratio.reset();
        capped.load.tangential_force = coulombs.tangential_force;
        const History limited = run_bem(capped), flows = run_bem(soft), never = run_bem(stiff);
        for (std::size_t n = 0; n < coulombs.shift_per_period.size(); ++n) {
            EXPECT_NEAR(never.shift_per_period[n] / coulombs.shift_per_period[n], 1, 1e-5) << n;
            // 10 Pa/m times 0.1 mm over the stress: 1e-8.
            EXPECT_NEAR(flows.shift_per_period[n] / limited.shift_per_period[n], 1, 1e-5) << n;
        }
        EXPECT_GT(limited.shift_per_period.front() / coulombs.shift_per_period.front(), 1.05);
    }
}

TEST(BemHardeningRolled, IsThatOfAPathOfTheSameMotion) {
    Case c = rolled(.2, .3, 2, 10);
    c.load.normal_force.reset();
    c.load.indentation = 4e-4;
    c.friction.yield = InterfaceYield{1.2e5, 3e9};
    c.rolling->amplitude_ratio.reset();
    c.rolling->amplitude = 1e-3;
    const History h = run_bem(c);
    Case path = c;
    path.rolling.reset();
    path.load = {};
    path.load.indentation = 4e-4;
    path.load.tangential_force = 0;
    path.prescribed_path.emplace();
    contact::PrescribedPath::Row row;
    row.normal = {contact::NormalControl::Kind::indentation, 4e-4};
    row.tangential[1] = {contact::TangentialControl::Kind::shift, 0};
    row.tangential[0] = {contact::TangentialControl::Kind::force, 0};
    path.prescribed_path->rows.push_back(row);
    for (const auto& step : h.steps) {
        if (step.tangential_force[0] == 0) continue;
        row.offset = step.offset;
        row.tangential[0].value = step.tangential_force[0];
        path.prescribed_path->rows.push_back(row);
    }
    const History same = run_bem(path);
    // A path takes off what has moved before a point is met; what rolls carries it along.
    EXPECT_NEAR(same.steps.back().shift[0] / h.steps.back().shift[0], 1, 3e-3);
}

// 0.6 of what the surfaces carry, of which they hold 0.7: more than a strength that does not harden
// holds. The limit is that of the surfaces.
TEST(BemHardeningRolled, ComesToRestWhereAStrengthRatchets) {
    Case c = rolled(.2, .6, 200, 12);
    constexpr double stress = 1.3e5;
    Case capped = c, hard = c;
    hard.friction.yield = InterfaceYield{stress, 4e9};
    hard.rolling->until = Case::Until::settled;
    const History h = run_bem(hard);
    EXPECT_EQ(h.verdict.state, State::shakedown) << name_of(h.verdict.state);
    EXPECT_NEAR(h.limit_tangential_ratio, run_bem(c).limit_tangential_ratio, 1e-12);
    EXPECT_LT(h.dissipation_per_period.back(), .05 * h.dissipation_per_period.front());
    capped.friction.strength_limit = stress;
    capped.load.tangential_ratio.reset();
    capped.load.tangential_force = h.tangential_force;
    capped.rolling->periods = 20;
    EXPECT_EQ(run_bem(capped).verdict.state, State::ratcheting);
    // More than the surfaces hold: the layer is worn in, then they ratchet.
    Case more = hard;
    more.load.tangential_ratio = .8;
    more.rolling->periods = 60;
    EXPECT_EQ(run_bem(more).verdict.state, State::ratcheting);
}

}  // namespace
}  // namespace tricontact::bem::hardening_rolled_test
