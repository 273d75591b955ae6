// Loops behind a rig that yields: springs in series. The drive's shift is that of the contact plus
// F/k, so that a path of drives computed from the rigid rig's forces has to lead to that rig's
// shifts and forces again; springs of the method of dimensionality reduction have no steps' error.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "bem/model.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/results.h"
#include "contact/cells.h"
#include "contact/model_on_rig.h"
#include "contact/path_cycles.h"
#include "contact/run.h"
#include "mdr/model.h"
#include "mdr/settings.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::rig_loop_test {
namespace {

using contact::NormalControl;
using contact::PrescribedPath;
using contact::RigStiffness;
using contact::TangentialControl;
namespace quantities = comparisons::quantities;

constexpr double mu = .57, radius = .04;

contact::Case case_of(const std::vector<PrescribedPath::Row>& rows, const RigStiffness& rig = {}) {
    contact::Case c;
    c.models = {"mdr"};
    c.indenter.radius = radius;
    c.substrate = {5.2e6, .5};
    c.friction.coefficient = mu;
    c.of<mdr::Settings>().springs = 20'000;
    c.of<contact::Cells>().per_radius = 8;
    c.of<RigStiffness>() = rig;
    c.prescribed_path = PrescribedPath{rows};
    const NormalControl hardest = c.prescribed_path->hardest_normal();
    (hardest.kind == NormalControl::Kind::force ? c.load.normal_force : c.load.indentation) =
        hardest.value;
    c.load.tangential_force = 0;
    return c;
}

PrescribedPath::Row row(const NormalControl& normal, double shift, int steps = 4) {
    PrescribedPath::Row row;
    row.normal = normal;
    row.tangential[0] = {TangentialControl::Kind::shift, shift};
    row.steps = steps;
    return row;
}

contact::History run(const contact::Case& c, bool by_grid = false) {
    auto model = by_grid ? bem::make_model(c, 1) : mdr::make_model(c);
    const RigStiffness& rig = c.of<RigStiffness>();
    if (rig.yields()) model = std::make_unique<contact::ModelOnRig>(std::move(model), rig);
    return contact::run(c, *model);
}

NormalControl force(double value) {
    return {NormalControl::Kind::force, value};
}
NormalControl depth(double value) {
    return {NormalControl::Kind::indentation, value};
}

/// Shifts of a loop that slips in part, then as a whole.
std::vector<PrescribedPath::Row> rows_of_loop(double unit, const NormalControl& normal) {
    std::vector<PrescribedPath::Row> rows;
    for (const double u : {0., .7, -.7, .7, -1.5, 1.5, -1.5, 1.5})
        rows.push_back(row(normal, u * unit));
    return rows;
}

double unit_shift(const NormalControl& normal) {
    return contact::half_space_scales(case_of({row(normal, 0)})).unit_shift;
}

/// Rows whose drive leaves the rows of `rigid` for the contact.
std::vector<PrescribedPath::Row> driven(const contact::Case& rigid, const contact::History& h,
                                        const RigStiffness& rig) {
    auto rows = rigid.prescribed_path->rows;
    const auto steps = contact::steps_at_rows(h);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].tangential[0].value = rig.drive_shift(*steps[r])[0];
        if (rows[r].normal.kind == NormalControl::Kind::indentation)
            rows[r].normal.value = rig.drive_depth(*steps[r]);
    }
    return rows;
}

/// What two runs differ by at the rows, over U_max and over mu F_N.
double apart(const contact::History& a, const contact::History& b) {
    const auto of_a = contact::steps_at_rows(a), of_b = contact::steps_at_rows(b);
    double worst = 0;
    for (std::size_t r = 0; r < of_a.size(); ++r)
        worst =
            std::max({worst, std::abs(of_a[r]->shift[0] - of_b[r]->shift[0]) / a.scales.unit_shift,
                      std::abs(of_a[r]->tangential_force[0] - of_b[r]->tangential_force[0]) /
                          a.friction_limit,
                      std::abs(of_a[r]->normal_force / of_b[r]->normal_force - 1)});
    return worst;
}

TEST(RigLoop, IsThatOfSpringsInSeries) {
    const NormalControl normal = force(20);
    const double unit = unit_shift(normal);
    const contact::Case rigid = case_of(rows_of_loop(unit, normal));
    const auto h = run(rigid);
    // A third, and three times, of what the contact's own stiffness is.
    for (const double share : {.3, 3.}) {
        const RigStiffness rig{share * mu * 20 / unit, {}};
        const contact::Case c = case_of(driven(rigid, h, rig), rig);
        const auto behind = run(c);
        EXPECT_LT(apart(h, behind), 1e-10) << share;
        const comparisons::Results own(rigid, h), results(c, behind);
        const auto number = [](const auto& of, const auto& q) { return of.number(q).value(); };
        EXPECT_NEAR(number(results, quantities::dissipation) / number(own, quantities::dissipation),
                    1, 1e-10);
        EXPECT_NEAR(
            (1 / number(results, quantities::drive_secant_stiffness) - 1 / *rig.tangential) *
                number(own, quantities::loop_secant_stiffness),
            1, 1e-10);
        EXPECT_NEAR(number(results, quantities::drive_shift) / unit, 1.5 + 1 / share, 1e-6);
        EXPECT_FALSE(own.number(quantities::drive_shift));
    }
}

// Gross slip: the contact slides by what the rig leaves, 4 mu F_N more of it per cycle.
TEST(RigLoop, SlidesByWhatTheRigLeaves) {
    const NormalControl normal = force(20);
    const double unit = unit_shift(normal), drive = 4 * unit;
    const RigStiffness rig{mu * 20 / unit, {}};
    const contact::Case c =
        case_of({row(normal, 0), row(normal, drive), row(normal, -drive), row(normal, drive)}, rig);
    const auto h = run(c);
    const comparisons::Results results(c, h);
    const theory::OscillatingForce full{mu, 20, c.materials().effective_shear_modulus(),
                                        h.scales.contact_radius, 1};
    EXPECT_NEAR(results.number(quantities::loop_shift).value() / unit, 3, 1e-6);
    EXPECT_NEAR(results.number(quantities::dissipation).value() /
                    (theory::cycle_dissipation(full) + 4 * mu * 20 * (3 * unit - unit)),
                1, 1e-6);
}

// Steps from row to row, so that the contact takes the same ones behind either rig.
TEST(RigLoop, LeavesDepthAndShiftTogether) {
    const NormalControl normal = depth(2e-4);
    const double unit = unit_shift(normal);
    auto rows = rows_of_loop(unit, normal);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r].steps = 1;
        rows[r].normal.value *= 1 + .1 * static_cast<double>(r % 3);
    }
    const contact::Case rigid = case_of(rows);
    const auto h = run(rigid);
    const RigStiffness rig{h.friction_limit / unit, h.scales.normal_force / 2e-4};
    const contact::Case c = case_of(driven(rigid, h, rig), rig);
    EXPECT_LT(apart(h, run(c)), 1e-8);  // a slip remembers the depths on the way
    EXPECT_NEAR(
        contact::half_space_scales(c).indentation / contact::half_space_scales(rigid).indentation,
        1, 1e-6);  // springs beside the closed form
}

// The solver's tolerance is 1e-7.
TEST(RigLoop, OfAGridIsThatOfItsOwnForces) {
    const NormalControl normal = force(20);
    const double unit = unit_shift(normal);
    std::vector<PrescribedPath::Row> rows;
    for (const double u : {0., .7, -.7, .7}) rows.push_back(row(normal, u * unit, 1));
    const contact::Case rigid = case_of(rows);
    const auto h = run(rigid, true);
    const RigStiffness rig{mu * 20 / unit, {}};
    EXPECT_LT(apart(h, run(case_of(driven(rigid, h, rig), rig), true)), 1e-5);
}

// F_N and the shift change in turn, everything sliding between: springs k = G* dx with the bounds
// b = (mu E*/G*)(d - x^2/R) of both loads dissipate, by the work of the shift over the closed
// cycle,
//   D = sum k [2 A (b1 + b2) - (b1^2 + b2^2)/2 - b1 b2 - 2 b2^2]
// with sum k b = mu F_N and the integrals of parabolas below.
TEST(RigLoop, UnderTwoNormalForcesWorksAsItsSpringsDo) {
    const NormalControl high = force(20), low = force(8);
    const double unit = unit_shift(high), shift = 2 * unit;
    const contact::Case c =
        case_of({row(high, 0), row(high, shift), row(low, shift), row(low, -shift),
                 row(high, -shift), row(high, shift), row(low, shift)});
    const auto h = run(c);
    ASSERT_EQ(h.dissipation_per_period.size(), 1u);
    const double modulus = c.materials().effective_modulus(),
                 shear = c.materials().effective_shear_modulus(), factor = mu * modulus / shear;
    const auto hertz = [&](double normal) {
        return std::pow(.75 * normal / (modulus * std::sqrt(radius)), 2. / 3);
    };
    const double d1 = hertz(20), d2 = hertz(8), a1 = std::sqrt(radius * d1),
                 a2 = std::sqrt(radius * d2);
    const double squares = shear * factor * factor, b11 = squares * 16 / 15 * d1 * d1 * a1,
                 b22 = squares * 16 / 15 * d2 * d2 * a2,
                 b12 = squares * a2 * (4. / 3 * d1 * d2 - 4. / 15 * d2 * d2);
    const double exact = 2 * shift * mu * (20 + 8) - (b11 + b22) / 2 - b12 - 2 * b22;
    EXPECT_NEAR(h.dissipation_per_period[0] / exact, 1, 1e-6);
}

// F_T in proportion to F_N, slower than friction grows: nothing slips on the way up, and the same
// way back neither (Mindlin and Deresiewicz 1953).
TEST(RigLoop, BelowFrictionOfAnOscillatingNormalForceNothingWorks) {
    std::vector<PrescribedPath::Row> rows;
    for (const double f : {10., 20., 10., 20.}) {
        rows.push_back(row(force(f), 0, 10));
        rows.back().tangential[0] = {TangentialControl::Kind::force, .4 * mu * (f - 10)};
    }
    const contact::Case c = case_of(rows);
    const auto h = run(c);
    const auto loops = comparisons::friction_loops(c, h);
    ASSERT_EQ(loops.size(), 1u);
    // The depth is no linear function of F_N within a step, of which there are ten.
    EXPECT_LT(h.dissipation_per_period[0] / (h.friction_limit * h.scales.unit_shift), 1e-5);
}

}  // namespace
}  // namespace tricontact::rig_loop_test
