#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "contact/history.h"
#include "contact/surface_audit.h"

namespace tricontact::audit_test {
namespace {

using contact::Audit;
using contact::ContactState;
using contact::NormalControl;
using contact::TangentialControl;
using contact::TangentialField;

const Audit::Check& check_of(const Audit& audit, const std::string& name) {
    for (const auto& check : audit.checks())
        if (check.name == name) return check;
    throw std::out_of_range(name);
}

TEST(Audit, KeepsTheWorst) {
    Audit audit;
    EXPECT_TRUE(audit.passed());
    audit.record("force", 1e-12, 1e-9);
    audit.record("gap", 2e-8, 1e-7);
    audit.record("force", 3e-11, 1e-9);
    audit.record("force", 2e-12, 1e-9);
    ASSERT_EQ(audit.checks().size(), 2u);
    EXPECT_EQ(check_of(audit, "force").worst, 3e-11);
    EXPECT_TRUE(audit.passed());
    audit.record("gap", 1.01e-7, 1e-7);
    EXPECT_FALSE(audit.passed());
    EXPECT_FALSE(check_of(audit, "gap").passed());
    EXPECT_TRUE(check_of(audit, "force").passed());
}

TEST(Audit, NotANumberNeverPasses) {
    Audit audit;
    audit.record("force", std::nan(""), 1e-9);
    audit.record("force", 0, 1e-9);
    EXPECT_FALSE(audit.passed());
    EXPECT_EQ(check_of(audit, "force").worst, std::numeric_limits<double>::infinity());
}

TEST(SurfaceAudit, NormalContact) {
    contact::NormalSolution solution;
    solution.pressure = {0, 2, 3};
    solution.residual = 1e-9;
    const std::vector<double> area{1, 2, 1};
    const NormalControl force{NormalControl::Kind::force, 7};
    Audit good;
    contact::audit_normal(solution, force, area, 1e-8, good);
    EXPECT_TRUE(good.passed());
    EXPECT_EQ(check_of(good, "normal_force").worst, 0);

    Audit bad;
    solution.pressure = {-.03, 2.5, 3};
    solution.residual = 1e-7;
    contact::audit_normal(solution, force, area, 1e-8, bad);
    EXPECT_DOUBLE_EQ(check_of(bad, "pressure_nonnegative").worst, .01);
    EXPECT_NEAR(check_of(bad, "normal_force").worst, .97 / 7, 1e-15);
    for (const auto& check : bad.checks()) EXPECT_FALSE(check.passed()) << check.name;
}

/// Three points: open, sticking, slipping along its traction.
struct SoundStep {
    std::vector<double> bound{0, 2, 1};
    std::vector<double> area{1, 1, 2};
    TangentialField traction{3}, slip{3};
    std::vector<ContactState> state{ContactState::open, ContactState::stick, ContactState::slip};
    std::array<TangentialControl, 2> control;

    SoundStep() {
        traction.x = {0, 1.2, .6};
        traction.y = {0, -.5, .8};
        slip.x = {0, 0, .3};
        slip.y = {0, 0, .4};
        control[0].value = 2.4;
        control[1].value = 1.1;
    }
    Audit audit() const {
        Audit result;
        contact::audit_tangential({bound, area, traction, slip, state, control, .1}, 1e-7, result);
        return result;
    }
    bool fails(const std::string& name) const {
        const Audit result = audit();
        for (const auto& check : result.checks())
            if (check.name != name && !check.passed()) return false;
        return !check_of(result, name).passed();
    }
};

TEST(SurfaceAudit, SoundStepPasses) {
    EXPECT_TRUE(SoundStep().audit().passed());
}

TEST(SurfaceAudit, EachViolationIsSeenByItsCheck) {
    SoundStep excess;
    excess.bound[1] = 1.2999;  // |t| = 1.3
    EXPECT_TRUE(excess.fails("friction_bound"));

    SoundStep creeping;
    creeping.slip.y[1] = 1e-6;
    EXPECT_TRUE(creeping.fails("no_slip_where_stick"));

    SoundStep sideways;
    sideways.slip.x[2] += 1e-6;
    EXPECT_TRUE(sideways.fails("slip_along_traction"));

    SoundStep far;  // a direction as wrong, of a slip far longer than mu d
    far.slip.x[2] = 3e4;
    far.slip.y[2] = 4e4 + 1e-2;
    EXPECT_TRUE(far.audit().passed());
    far.slip.y[2] = 4e4 + 1;
    EXPECT_TRUE(far.fails("slip_along_traction"));

    SoundStep backwards;
    backwards.slip.x[2] *= -1;
    backwards.slip.y[2] *= -1;
    EXPECT_TRUE(backwards.fails("slip_along_traction"));

    SoundStep unbalanced;
    unbalanced.control[1].value = 1.1 * (1 + 1e-8);
    EXPECT_TRUE(unbalanced.fails("tangential_force"));
    unbalanced.control[1].kind = TangentialControl::Kind::shift;  // then any force is right
    EXPECT_TRUE(unbalanced.audit().passed());
}

TEST(SurfaceAudit, BrokenNumbersDoNotHide) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    // in every field and at every point, also before sound ones
    for (int i = 0; i < 3; ++i) {
        SoundStep traction, slip;
        traction.traction.x[i] = nan;
        EXPECT_FALSE(traction.audit().passed()) << i;
        slip.slip.y[i] = nan;
        EXPECT_EQ(slip.audit().passed(), i == 0) << i;  // open points do not slip
        contact::NormalSolution solution;
        solution.pressure = {0, 2, 3};
        solution.pressure[i] = nan;
        Audit audit;
        contact::audit_normal(solution, {NormalControl::Kind::indentation, 1}, {1, 2, 1}, 1, audit);
        EXPECT_FALSE(audit.passed()) << i;
    }
}

}  // namespace
}  // namespace tricontact::audit_test
