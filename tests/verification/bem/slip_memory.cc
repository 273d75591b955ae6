// Friction that remembers the way of slip: mu(s) that falls, a layer between the surfaces that
// yields and hardens.
//   soft springs  each point alone, by hand, jumps too;
//   elastic body  the same states and jumps by slow viscous slip over the dense matrix;
//   limits        those of Coulomb's law.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "bem/model.h"
#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/prescribed_path.h"
#include "contact/run.h"
#include "contact/surface_model.h"
#include "tests/verification/bem/rig.h"

namespace tricontact::bem::slip_memory_test {
namespace {

using contact::Case;
using contact::FrictionWeakening;
using contact::History;
using contact::NormalControl;
using contact::TangentialControl;

constexpr double depth = 3e-4;

/// A half-space pressed by `depth`, uncoupled, whose shift follows `shifts` [m], a step each.
Case shifted(const std::vector<double>& shifts, double cells_per_radius) {
    Case c = rig_case(0, .1, 1);
    c.rolling.reset();
    c.substrate.poisson = 0;
    c.indenter.material.reset();
    c.contact.coupling = false;
    c.load = {};
    c.load.indentation = depth;
    c.load.tangential_force = 0;
    c.of<contact::Cells>().spacing = std::sqrt(2 * c.indenter.radius * depth) / cells_per_radius;
    c.prescribed_path.emplace();
    std::vector<double> rows = shifts;
    rows.insert(rows.begin(), 0);  // pressed alone
    for (const double shift : rows) {
        contact::PrescribedPath::Row row;
        row.normal = {NormalControl::Kind::indentation, depth};
        row.tangential[0] = {TangentialControl::Kind::shift, shift};
        row.tangential[1] = {TangentialControl::Kind::shift, 0};
        row.steps = 1;
        c.prescribed_path->rows.push_back(row);
    }
    return c;
}

/// F_T of the rows.
std::vector<double> forces(const History& h, std::size_t rows) {
    std::vector<double> force;
    for (std::size_t k = h.steps.size() - rows; k < h.steps.size(); ++k)
        force.push_back(h.steps[k].tangential_force[0]);
    return force;
}

/// On springs much softer than the body: k_n d is p0, and mu p0/k_t the unit of shifts.
struct SoftRig {
    Case c;
    double peak, spring, unit;
};
SoftRig soft(const std::vector<double>& shifts_over_unit) {
    SoftRig rig{shifted(shifts_over_unit, 40), 0, 0, 0};
    constexpr double softness = 1e-4;
    const double a = std::sqrt(2 * rig.c.indenter.radius * depth);
    const double k_n = softness * rig.c.materials().effective_modulus() / a;
    rig.spring = .7 * k_n;
    rig.c.interface = {k_n, rig.spring};
    rig.peak = k_n * depth;
    rig.unit = *rig.c.friction.coefficient * rig.peak / rig.spring;
    for (auto& row : rig.c.prescribed_path->rows) row.tangential[0].value *= rig.unit;
    return rig;
}

/// Sum of a traction that depends on the pressure, over the paraboloid of pressures [N].
double summed(const SoftRig& rig, const std::function<double(double)>& traction) {
    constexpr int n = 20000;
    const double area = 2 * std::numbers::pi * rig.c.indenter.radius * depth;
    double sum = 0;  // p falls evenly over the area
    for (int i = 0; i < n; ++i) sum += traction(rig.peak * (i + .5) / n);
    return sum * area / n;
}

// Cells of a/40 and bodies of 1e-4 of the softness: see interface.cc.
constexpr double allowed = 2e-3;

TEST(BemSlipMemory, PointsOnSoftSpringsWeakenAlone) {
    const std::vector<double> at{.3, .6, .9, 1.2, 1.5};
    SoftRig rig = soft(at);
    const double mu = *rig.c.friction.coefficient, drop = .25 * mu, length = .5 * rig.unit;
    rig.c.friction.weakening = FrictionWeakening{FrictionWeakening::Law::linear, drop, length};
    const History h = run_bem(rig.c);
    const auto force = forces(h, at.size());
    for (std::size_t k = 0; k < at.size(); ++k) {
        const double U = at[k] * rig.unit, K = rig.spring;
        const double expected = summed(rig, [&](double p) {
            if (K * U <= mu * p) return K * U;
            const double s = (K * U - mu * p) / (K - drop * p / length);  // K is above the fall
            return s < length ? K * (U - s) : (mu - drop) * p;
        });
        EXPECT_NEAR(force[k] / expected, 1, allowed) << k;
    }
    EXPECT_NEAR(force.back() / h.scales.normal_force, mu - drop, 1e-9);
    for (const auto& step : h.steps) EXPECT_EQ(step.may_differ, 0);
}

// Where the bound falls faster than the spring lets go, a point jumps as it begins to slip, and its
// spring sets free what friction does not take.
TEST(BemSlipMemory, PointsOnSoftSpringsJump) {
    const std::vector<double> at{.5, .502};
    SoftRig rig = soft(at);
    const double mu = *rig.c.friction.coefficient, drop = .5 * mu, length = .01 * rig.unit;
    rig.c.friction.weakening = FrictionWeakening{FrictionWeakening::Law::linear, drop, length};
    const History h = run_bem(rig.c);
    const double K = rig.spring;
    const auto expected = [&](double U) {
        return summed(rig, [&](double p) {
            // Those of less pressure have let go at a smaller shift, slowly where p is small.
            if (K * U <= mu * p) return K * U;
            const double fall = drop * p / length;
            const double s = fall < K ? (K * U - mu * p) / (K - fall) : length;
            return s < length ? K * (U - s) : (mu - drop) * p;
        });
    };
    const auto force = forces(h, at.size());
    for (std::size_t k = 0; k < at.size(); ++k)
        EXPECT_NEAR(force[k] / expected(at[k] * rig.unit), 1, 2 * allowed) << k;
    EXPECT_EQ(h.steps.back().may_differ, 1);
}

void expect_hardening_alone(double hardening_over_spring) {
    const std::vector<double> at{.3, .6, .9, .2, -.3};
    SoftRig rig = soft(at);
    const double mu = *rig.c.friction.coefficient, K = rig.spring, flow = .3 * mu * rig.peak,
                 hardening = hardening_over_spring * K;
    rig.c.friction.yield = contact::InterfaceYield{flow, hardening};
    const History h = run_bem(rig.c);
    const auto force = forces(h, at.size());
    // By increments of the shift, each of which is elastic, flows, or slips.
    const auto traction = [&](double p, std::size_t row) {
        double t = 0, before = 0, strength = flow;
        for (std::size_t k = 0; k <= row; ++k) {
            const double U = at[k] * rig.unit, sign = U > before ? 1 : -1;
            double trial = t + K * (U - before);
            if (std::abs(trial) > std::min(strength, mu * p)) {
                if (strength < mu * p) {
                    const double u = (std::abs(trial) - strength) / (K + hardening);
                    const double taken = std::min(u, (mu * p - strength) / hardening);
                    strength += hardening * taken;
                }
                trial = sign * std::min(strength, mu * p);
            }
            t = trial;
            before = U;
        }
        return t;
    };
    const double scale = mu * h.scales.normal_force;
    for (std::size_t k = 0; k < at.size(); ++k)
        EXPECT_NEAR((force[k] - summed(rig, [&](double p) { return traction(p, k); })) / scale, 0,
                    allowed)
            << k << ' ' << hardening_over_spring;
}

TEST(BemSlipMemory, LayerOnSoftSpringsHardens) {
    for (const double hardening : {.01, .4, 30., 1e6}) expect_hardening_alone(hardening);
}

/// Slow viscous slip along x over the dense matrix, from rest: ds/dt ~ t - B(s) where it slips. It
/// grows until it is in equilibrium, in whatever jump.
class ViscousSlip {
  public:
    explicit ViscousSlip(const Case& c) {
        const auto substrate = make_substrate(c, 1, Body::half_space);
        const contact::Compliance& compliance = substrate->compliance();
        contact::SurfaceModel pressed("bem", *make_substrate(c, 1, Body::half_space),
                                      c.make_indenter(), c.friction.law(), 1e-9, c.contact);
        contact::LoadStep press = contact::press_step(c);
        press.friction = false;
        pressed.advance(press);
        const auto surface = pressed.surface();
        std::vector<std::size_t> on;
        for (std::size_t i = 0; i < surface.normal_traction.size(); ++i)
            if (surface.normal_traction[i] > 0) on.push_back(i);
        area_ = compliance.points().area[on.front()];
        const std::size_t n = surface.normal_traction.size(), m = on.size();
        matrix_.resize(m, m);
        for (std::size_t k = 0; k < m; ++k) {
            contact::TangentialField unit(n), moved(n);
            unit.x[on[k]] = 1;
            compliance.tangential(unit, moved);
            for (std::size_t i = 0; i < m; ++i) matrix_(i, k) = moved.x[on[i]];
        }
        inverse_ = matrix_.inverse();
        pressure_.resize(m);
        for (std::size_t k = 0; k < m; ++k) pressure_[k] = surface.normal_traction[on[k]];
        slip_ = Eigen::VectorXd::Zero(m);
    }

    double force(double shift, const std::function<double(double, double)>& bound) {
        const double step = 1 / inverse_.norm();
        for (int k = 0; k < 400000; ++k) {
            const Eigen::VectorXd t =
                inverse_ * (Eigen::VectorXd::Constant(slip_.size(), shift) - slip_);
            double worst = 0;
            for (Eigen::Index i = 0; i < slip_.size(); ++i) {
                const double excess = t[i] - bound(pressure_[i], slip_[i]);
                if (excess > 0) slip_[i] += step * excess;
                worst = std::max(worst, excess);
            }
            if (worst < 1e-7 * pressure_.maxCoeff()) return area_ * t.sum();
        }
        ADD_FAILURE() << "still slips";
        return 0;
    }

  private:
    double area_ = 0;
    Eigen::MatrixXd matrix_, inverse_;
    Eigen::VectorXd pressure_, slip_;
};

std::vector<double> rising(double last, int n) {
    std::vector<double> shifts;
    for (int k = 1; k <= n; ++k) shifts.push_back(last * k / n);
    return shifts;
}

// What is left of the excess is 1e-7 of p0; the solver's tolerance is 1e-7 of its own.
void expect_viscous_states(const Case& c, const std::function<double(double, double)>& bound) {
    const auto& rows = c.prescribed_path->rows;
    const auto force = forces(run_bem(c), rows.size() - 1);
    ViscousSlip viscous(c);
    const double scale = *std::ranges::max_element(force);
    for (std::size_t k = 0; k < force.size(); ++k)
        EXPECT_NEAR(viscous.force(rows[k + 1].tangential[0].value, bound) / scale, force[k] / scale,
                    2e-5)
            << k;
}

TEST(BemSlipMemory, ElasticBodyWeakensAsByViscousSlip) {
    for (const double length : {30e-6, 6e-6}) {  // smooth, and with a jump
        Case c = shifted(rising(2.6e-4, 13), 6);
        const double mu = *c.friction.coefficient, drop = .6 * mu;
        c.friction.weakening = FrictionWeakening{FrictionWeakening::Law::linear, drop, length};
        expect_viscous_states(
            c, [&](double p, double s) { return (mu - drop * std::min(1., s / length)) * p; });
    }
}

TEST(BemSlipMemory, ElasticBodyHardensAsByViscousSlip) {
    for (const double hardening : {1e9, 1e10, 1e11}) {  // [Pa/m]; the contact: about 2e9
        Case c = shifted(rising(4e-4, 8), 6);
        const double mu = *c.friction.coefficient, flow = 5e4;
        c.friction.yield = contact::InterfaceYield{flow, hardening};
        expect_viscous_states(
            c, [&](double p, double s) { return std::min(mu * p, flow + hardening * s); });
    }
}

// A layer that does not harden is a limit of strength, one that hardens endlessly does not flow.
// The contact resists by about 2e9 Pa/m; pressed and coupled, loaded and unloaded.
TEST(BemSlipMemory, HardeningFromNoneToNoYield) {
    const std::vector<double> shifts{1e-4, 2e-4, 3e-4, 1e-4, -2e-4};
    Case c = shifted(shifts, 8);
    c.substrate.poisson = .3;
    c.contact.coupling = true;
    constexpr double flow = 1e5;
    const auto after = [&](double hardening) {
        Case with = c;
        with.friction.yield = contact::InterfaceYield{flow, hardening};
        return forces(run_bem(with), shifts.size());
    };
    Case capped = c;
    capped.friction.strength_limit = flow;
    const auto none = forces(run_bem(capped), shifts.size());
    const auto never = forces(run_bem(c), shifts.size());
    const auto soft = after(10), stiff = after(1e16);
    std::vector<double> last = none;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        EXPECT_NEAR(soft[k] / none[k], 1, 1e-6) << k;  // 10 Pa/m times 0.3 mm over 0.1 MPa: 3e-8
        EXPECT_NEAR(stiff[k] / never[k], 1, 1e-6) << k;
    }
    // Between both the force of the first step rises with the hardening; all converge.
    for (const double hardening : {1e8, 1e9, 1e10, 1e11, 1e12, 1e13}) {
        const auto force = after(hardening);
        EXPECT_GT(force[0], last[0]) << hardening;
        EXPECT_LT(force[0], never[0]) << hardening;
        last = force;
    }
}

// From a tenth of the contact's stiffness to a hundred times it, on the way up and back: products
// of the compliance. 1.8 times Coulomb's law where the preconditioner is that of the bodies alone.
TEST(BemSlipMemory, SoftLayersCostWhatCoulombsLawDoes) {
    std::vector<double> shifts = rising(3e-4, 6);
    for (const double back : {2.5e-4, 2e-4}) shifts.push_back(back);
    Case c = shifted(shifts, 30);
    c.substrate.poisson = .5;
    const auto products = [&](std::optional<double> hardening) {
        if (hardening) c.friction.yield = contact::InterfaceYield{8e4, *hardening};
        int sum = 0;
        for (const auto& step : run_bem(c).steps) sum += step.tangential_iterations;
        return sum;
    };
    const int coulomb = products({});
    for (const double hardening : {1e8, 1e9, 5e9, 1e11})
        EXPECT_LT(products(hardening), 1.3 * coulomb) << hardening;
}

TEST(BemSlipMemory, LimitsAreCoulombs) {
    const auto shifts = rising(2e-4, 4);
    Case c = shifted(shifts, 8);
    const auto at_rest = forces(run_bem(c), shifts.size());
    const double mu = *c.friction.coefficient, drop = .3 * mu;
    Case falls = c;
    falls.friction.weakening = FrictionWeakening{FrictionWeakening::Law::exponential, drop, 1e3};
    Case slid = c;
    slid.friction.coefficient = mu - drop;
    const auto sliding = forces(run_bem(slid), shifts.size());
    const auto slowly = forces(run_bem(falls), shifts.size());
    falls.friction.weakening->length = 1e-13;
    const auto at_once = forces(run_bem(falls), shifts.size());
    for (std::size_t k = 0; k < shifts.size(); ++k) {
        EXPECT_NEAR(slowly[k] / at_rest[k], 1, 1e-6);  // s/D_c = 1e-7 of the drop
        EXPECT_NEAR(at_once[k] / sliding[k], 1, 1e-4);
    }
}

}  // namespace
}  // namespace tricontact::bem::slip_memory_test
