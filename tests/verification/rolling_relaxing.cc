// A rigid cylinder rolling over a relaxing half-space (Hunter 1961) and over a bed of relaxing
// springs, both of a standard solid.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "contact/relaxing_substrate.h"
#include "rolling/run.h"
#include "tests/unit/rolling_problems.h"

namespace tricontact {
namespace {

using rolling_test::Rig;

constexpr double ratio = 2, relaxation_time = .3;  // g = G2/G1 [-], tau [s]

/// Springs side by side, p = k u and t = k u.
class Bed final : public contact::Compliance {
  public:
    Bed(contact::ContactPoints points, double stiffness)
        : points_(std::move(points)), stiffness_(stiffness) {}
    const contact::ContactPoints& points() const override { return points_; }
    bool is_coupled() const override { return false; }
    void normal(std::span<const double> p, std::span<double> u_z) const override {
        for (std::size_t i = 0; i < p.size(); ++i) u_z[i] = p[i] / stiffness_;
    }
    void tangential(const contact::TangentialField& t, contact::TangentialField& u) const override {
        normal(t.x, u.x);
        normal(t.y, u.y);
    }
    double local_tangential() const override { return 1 / stiffness_; }
    void precondition_tangential(const contact::TangentialField& r,
                                 contact::TangentialField& z) const override {
        z = r;
    }

  private:
    contact::ContactPoints points_;
    double stiffness_;
};

/// A row that sees `ahead` half lengths of the surface in front of the centre.
contact::ContactPoints row(const Rig& rig, double ahead) {
    const int behind = static_cast<int>(1.3 * rig.n), front = static_cast<int>(ahead * rig.n);
    auto grid = contact::ContactPoints::grid(behind + front + 1, 1, {-behind * rig.cell(), 0},
                                             {rig.cell(), rig.row_length()});
    grid.line_length = rig.row_length();
    return grid;
}

rolling::RollingState roll(const Rig& rig, std::shared_ptr<const contact::Compliance> relaxed,
                           double force, double speed) {
    auto problem = rig.row(0);
    problem.normal.value = force;
    problem.drive.creepage = {0, 0};
    problem.speed = speed;
    problem.tolerance = 1e-7;
    const contact::RelaxingSubstrate substrate(std::move(relaxed), {{{ratio, relaxation_time}}});
    return rolling::run(substrate, problem).steady;
}

/// Hunter (1961), J. Mech. Phys. Solids 9, 219: half length l about the middle m, force per length
/// and lead of the pressure. With lambda = v tau, Lambda = (1 + g) lambda, z = l/lambda,
/// y = l/Lambda and E* relaxed, sigma = p - lambda p' solves Flamant's equation:
///   sigma = E*/(2R) [sqrt(l^2 - s^2) + (kappa s + B)/sqrt(l^2 - s^2)],   kappa = Lambda - m;
/// p vanishes at the trailing edge, and the surface arrives at the leading edge with the roller's
/// slope: B = g lambda l I1(z)/(I0(z) + I1(z) K0(y)/K1(y)), m = B K0(y)/(l K1(y)).
struct Hunter {
    double force, lead;
    Hunter(const Rig& rig, double l, double lambda) {
        const double all = (1 + ratio) * lambda, z = l / lambda, y = l / all;
        const double k = std::cyl_bessel_k(0, y) / std::cyl_bessel_k(1, y);
        const double i_0 = std::cyl_bessel_i(0, z), i_1 = std::cyl_bessel_i(1, z);
        const double b = ratio * lambda * l * i_1 / (i_0 + i_1 * k), m = b * k / l;
        const double unit = std::numbers::pi * rig.modulus() / (2 * rig.radius);
        force = unit * (l * l / 2 + b);
        lead = m + unit * (all - m) * l * l / 2 / force - lambda;
    }
};

/// The half length that carries the force per length [m], by bisection.
double hunter_half_length(const Rig& rig, double force, double lambda) {
    double low = .1 * rig.half_length, high = 2 * rig.half_length;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        (Hunter(rig, middle, lambda).force < force ? low : high) = middle;
    }
    return low;
}

// The surface is taken for relaxed and level where it enters the grid: the farther ahead, the more
// of what came before the material remembers.
TEST(RollingRelaxing, ACylinderMeetsTheResistanceThatHunterFound) {
    for (const double lambda : {.1, .5, 1.5}) {
        std::vector<double> error;
        for (const int n : {16, 33}) {
            const Rig rig{.n = n};
            const double speed = lambda * rig.half_length / relaxation_time;
            const auto state =
                roll(rig, bem::half_space_compliance(rig.materials(), row(rig, 8 + 16 * lambda), 1),
                     rig.row_force(), speed);
            const double force = rig.row_force() / rig.row_length();
            const double l = hunter_half_length(rig, force, lambda * rig.half_length);
            const Hunter hunter(rig, l, lambda * rig.half_length);
            EXPECT_NEAR(state.half_length / l, 1, 1.5 / n) << lambda;
            error.push_back(std::abs(state.pressure_lead / hunter.lead - 1));
        }
        EXPECT_LT(error[1], 2e-3) << lambda;
        // Where the way of a relaxation is some cells the grid is what errs; else what it does not
        // see ahead.
        if (lambda < .2) {
            EXPECT_LT(error[1], .5 * error[0]);
        }
    }
}

// Slow or fast the solid is elastic, relaxed or not: no resistance, and between Hertz' two lengths.
TEST(RollingRelaxing, NothingResistsSlowOrFastRolling) {
    const Rig rig{.n = 20};
    const auto relaxed = [&] {
        return bem::half_space_compliance(rig.materials(), row(rig, 5), 1);
    };
    const double unit = rig.half_length / relaxation_time;
    const auto slow = roll(rig, relaxed(), rig.row_force(), 2e-3 * unit);
    const auto middle = roll(rig, relaxed(), rig.row_force(), .4 * unit);
    const auto fast = roll(rig, relaxed(), rig.row_force(), 500 * unit);
    EXPECT_GT(middle.pressure_lead, .1 * rig.half_length);
    EXPECT_LT(std::abs(slow.pressure_lead), .02 * middle.pressure_lead);
    EXPECT_LT(std::abs(fast.pressure_lead), .05 * middle.pressure_lead);
    EXPECT_NEAR(slow.half_length, rig.half_length, rig.cell());
    EXPECT_NEAR(fast.half_length, rig.half_length / std::sqrt(1 + ratio), rig.cell());
}

// Springs of p = k [u + g int exp(-(t - t')/tau) du], u = (a^2 - x^2)/(2R) from the leading edge a:
//   p = k/R {(a^2 - x^2)/2 + g lambda [x + lambda - (a + lambda) exp((x - a)/lambda)]}
// down to p = 0; Johnson (1985), section 9.4.
TEST(RollingRelaxing, ABedOfRelaxingSpringsIsExact) {
    const double lambda = .7, stiffness = 4e8;  // of the leading edge's distance a; [Pa/m]
    std::vector<double> error;
    for (const int n : {20, 41, 80}) {
        const Rig rig{.n = n};
        const double a = rig.half_length, l = lambda * a;
        double force = 0, moment = 0;
        const int parts = 20000;  // midpoints
        for (int k = 0; k < parts; ++k) {
            const double x = a - (k + .5) * 2 * a / parts;
            const double p =
                stiffness / rig.radius *
                ((a * a - x * x) / 2 + ratio * l * (x + l - (a + l) * std::exp((x - a) / l)));
            if (p < 0) break;
            force += p * 2 * a / parts;
            moment += x * p * 2 * a / parts;
        }
        const auto state = roll(rig, std::make_shared<Bed>(row(rig, 2), stiffness),
                                force * rig.row_length(), l / relaxation_time);
        EXPECT_NEAR(state.indentation, a * a / (2 * rig.radius), .5 / n * state.indentation);
        error.push_back(state.pressure_lead / (moment / force) - 1);
    }
    EXPECT_LT(std::abs(error[2]), 1e-2);
    EXPECT_LT(std::abs(error[2]), .5 * std::abs(error[0]));
}

}  // namespace
}  // namespace tricontact
