// Prescribed paths on half-spaces: a twist against Lubkin, forces in turn against the method of
// dimensionality reduction, which has Mindlin and Deresiewicz' closed forms exactly
// (tests/unit/mdr/prescribed_path.cc), energy against the work of the loads, symmetry, relaxation.

#include "contact/prescribed_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/cells.h"
#include "mdr/model.h"
#include "tests/verification/bem/rig.h"
#include "theory/torsion.h"

namespace tricontact::bem::bem_prescribed_path_test {
namespace {

using contact::Case;
using contact::History;
using contact::NormalControl;
using contact::PrescribedPath;
using contact::TangentialControl;
using Row = PrescribedPath::Row;

Row row(double normal_force) {
    Row row;
    row.normal.value = normal_force;
    return row;
}

Case following(std::vector<Row> rows, double cells_per_radius, int steps) {
    Case c = rig_case(0, .1, 1);
    c.rolling.reset();
    c.of<contact::Cells>().spacing.reset();
    c.of<contact::Cells>().per_radius = cells_per_radius;
    for (Row& row : rows) row.steps = steps;
    c.load.tangential_ratio.reset();
    c.load.tangential_force = 0;
    c.prescribed_path = PrescribedPath{std::move(rows)};
    c.load.normal_force = c.prescribed_path->hardest_normal().value;
    return c;
}

/// Largest difference from Lubkin's torque over mu F_N a, at twists that leave these stick radii.
double worst_torque(double cells_per_radius) {
    constexpr std::array stick_radii{.95, .7, .3};
    Case c = following({row(21.1)}, cells_per_radius, 1);
    c.indenter.material.reset();  // rigid
    const double a = half_space_scales(c).contact_radius;
    const double friction = c.friction_coefficient() * 21.1, shear = c.substrate.shear_modulus();
    for (const double c_over_a : stick_radii) {
        c.prescribed_path->rows.push_back(row(21.1));
        c.prescribed_path->rows.back().rotation =
            theory::twist_ratio(c_over_a) * friction / (shear * a * a);
    }
    const History history = run_bem(c);
    double worst = 0;
    for (std::size_t k = 0; k < stick_radii.size(); ++k) {
        const double torque = history.steps[history.steps.size() - stick_radii.size() + k].torque;
        worst = std::max(worst,
                         std::abs(torque / (friction * a) - theory::torque_ratio(stick_radii[k])));
    }
    return worst;
}

// The cells at the edge of contact and stick make it of the first order at least.
TEST(BemPrescribedPath, TwistsAsLubkinSays) {
    const double coarse = worst_torque(10), fine = worst_torque(20);
    EXPECT_LT(fine, 2e-3);
    EXPECT_GT(std::log2(coarse / fine), .8);
}

// nu = 0 and equal bodies: no coupling, no traction across, so that MDR is exact for BEM as well.
TEST(BemPrescribedPath, LoadsInTurnAsTheExactSprings) {
    std::vector<Row> rows;
    for (const auto& [normal, tangential] : std::vector<std::array<double, 2>>{
             {10, 0}, {20, 4}, {15, 6}, {15, -3}, {25, 2}, {21, 9}}) {
        rows.push_back(row(normal));
        rows.back().tangential[0].value = tangential;
    }
    Case c = following(rows, 20, 4);
    c.substrate.poisson = 0;
    c.indenter.material = c.substrate;
    const History bem = run_bem(c);
    const History mdr = contact::run(c, *mdr::make_model(c));
    ASSERT_EQ(bem.steps.size(), mdr.steps.size());
    for (std::size_t k = 0; k < bem.steps.size(); ++k)
        EXPECT_NEAR(bem.steps[k].shift[0], mdr.steps[k].shift[0], 2e-3 * mdr.scales.unit_shift)
            << k;
}

// Both forces rise in proportion from zero, F_T/F_N below mu: nothing slips, and U is F_T/F_N E*/G*
// d (Mindlin and Deresiewicz 1953), in one step as in many. Cells at the edge: .3 % of d with 15 in
// the radius; beside nu = 0 a point at the edge is moved by what is in contact already a little
// more along the force than across it, which one step takes for the mean.
TEST(BemPrescribedPath, ObliqueLoadingBelowFrictionIsExactInOneStep) {
    for (const double poisson : {0., .5})
        for (const int steps : {1, 10}) {
            std::vector<Row> rows{row(0), row(20)};
            rows[1].tangential[0].value = 4;
            Case c = following(rows, 15, steps);
            c.substrate.poisson = poisson;
            c.indenter.material.reset();  // rigid
            c.contact.coupling = false;
            const auto pair = c.materials();
            const double exact = 4. / 20 * pair.effective_modulus() /
                                 pair.effective_shear_modulus() * half_space_scales(c).indentation;
            const auto last = run_bem(c).steps.back();
            EXPECT_NEAR(last.shift[0], exact, 5e-3 * exact) << poisson << ' ' << steps;
            EXPECT_LT(last.slip_area, .1 * last.contact_area) << poisson << ' ' << steps;
        }
}

/// All at once: forces, a shift and a twist, without rolling, which does work that no force tells.
std::vector<Row> mixed_rows() {
    std::vector<Row> rows{row(12), row(20), row(16), row(18)};
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].tangential[0].value = std::array{0., 4., -3., 5.}[k];
        rows[k].tangential[1] = {TangentialControl::Kind::shift,
                                 std::array{0., 8e-6, -4e-6, 3e-6}[k]};
        rows[k].rotation = std::array{0., 4e-3, 6e-3, -5e-3}[k];
    }
    return rows;
}

/// Work of all loads from the first row on less what is stored and dissipated, over the work.
double missing_work(int steps) {
    const Case c = following(mixed_rows(), 10, steps);
    const History history = run_bem(c);
    double work = 0, dissipated = 0;
    for (std::size_t k = 1; k < history.steps.size(); ++k) {
        const auto &from = history.steps[k - 1], &to = history.steps[k];
        work += (from.normal_force + to.normal_force) / 2 * (to.indentation - from.indentation) +
                (from.torque + to.torque) / 2 * (to.rotation - from.rotation);
        for (int d = 0; d < 2; ++d)
            work += (from.tangential_force[d] + to.tangential_force[d]) / 2 *
                    (to.shift[d] - from.shift[d]);
        dissipated += to.dissipation;
    }
    const double stored = history.steps.back().stored_energy - history.steps.front().stored_energy;
    return std::abs(work - stored - dissipated) / dissipated;
}

// Friction takes its work at the tractions of the end of a step: of the first order.
TEST(BemPrescribedPath, WorkIsStoredOrDissipated) {
    const double coarse = missing_work(5), fine = missing_work(10), finest = missing_work(20);
    EXPECT_LT(finest, .05);
    EXPECT_GT(std::log2(coarse / fine), .7);
    EXPECT_GT(std::log2(fine / finest), .7);
}

// The whole path turned by a right angle, rolling included, turns all that comes of it.
TEST(BemPrescribedPath, TurnsWithItsLoads) {
    std::vector<Row> rows = mixed_rows(), turned = rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].offset = {4e-4 * static_cast<double>(k), -2e-4 * static_cast<double>(k)};
        turned[k].offset = {-rows[k].offset[1], rows[k].offset[0]};
        turned[k].tangential = {rows[k].tangential[1], rows[k].tangential[0]};
        turned[k].tangential[0].value *= -1;
    }
    const auto first = run_bem(following(rows, 8, 2)).steps.back();
    const auto second = run_bem(following(turned, 8, 2)).steps.back();
    // Of the solvers' tolerance, 1e-7, over all steps.
    EXPECT_NEAR(second.shift[1] / first.shift[0], 1, 1e-4);
    EXPECT_NEAR(-second.shift[0] / first.shift[1], 1, 1e-4);
    EXPECT_NEAR(-second.tangential_force[0] / first.tangential_force[1], 1, 1e-4);
    EXPECT_NEAR(second.torque / first.torque, 1, 1e-4);
}

// Twisted at once and held, at a constant depth and without slip: the torque relaxes as G does.
TEST(BemPrescribedPath, HeldTwistRelaxes) {
    constexpr double ratio = 1.7, tau = .3;
    std::vector<Row> rows(3, row(0));
    for (Row& row : rows) row.normal = {NormalControl::Kind::indentation, 4e-4};
    rows[1].time = 1e-9;
    rows[2].time = .2;
    rows[1].rotation = rows[2].rotation = 1e-4;
    Case c = following(rows, 8, 1);
    c.load.normal_force.reset();
    c.load.indentation = 4e-4;
    c.indenter.material.reset();
    c.friction.coefficient = 100;
    c.relaxation = contact::Relaxation{{{ratio, tau}}, contact::Relaxation::Bulk::proportional};
    c.load.press_steps = 1;
    const auto steps = run_bem(c).steps;
    const double held = steps.back().torque / steps[steps.size() - 2].torque;
    EXPECT_NEAR(held, (1 + ratio * std::exp(-.2 / tau)) / (1 + ratio), 1e-6);
}

}  // namespace
}  // namespace tricontact::bem::bem_prescribed_path_test
