// What a layer at finite strains has to be where the answer is known from another model: the linear
// layer at small strains, the elastic one at slow and at sudden relaxation, the whole body beside
// its half.

#include <gtest/gtest.h>

#include "fem/settings.h"
#include "tests/verification/fem/strained_rig.h"

namespace tricontact::fem::finite_strain_limits_test {
namespace {

using contact::Case;
using contact::History;

const contact::Relaxation rubber{{{.8, .5}, {.3, 5}}, {}};

/// Of elements, where both sides of an equation have the same ones [m].
constexpr double coarse = 2e-3;

/// Pressed with friction, loaded and rolled back and forth once, in few steps.
Case rolled_case(double size) {
    Case c = strained_case(size);
    c.load.tangential_force.reset();
    c.load.tangential_ratio = .5;
    c.load.press_steps = 3;
    c.rolling.emplace();
    c.rolling->amplitude = 1e-3;
    c.rolling->periods = 1;
    c.rolling->run_all = true;
    c.rolling->steps_per_quarter = 2;
    c.of<fem::Settings>().tolerance = 1e-8;
    return c;
}

History run(const Case& c) {
    const auto model = make_layer_model(c);
    History history = contact::run(c, *model);
    EXPECT_TRUE(history.audit.passed());
    return history;
}

/// d over its own, U, dissipation and stored energy, of all steps.
void expect_equal(const History& a, const History& b, double allowed) {
    ASSERT_EQ(a.steps.size(), b.steps.size());
    EXPECT_NEAR(a.scales.indentation / b.scales.indentation, 1, allowed);
    EXPECT_NEAR(a.scales.contact_radius / b.scales.contact_radius, 1, allowed);
    EXPECT_NEAR(a.scales.peak_pressure / b.scales.peak_pressure, 1, allowed);
    EXPECT_NEAR(a.scales.unit_shift / b.scales.unit_shift, 1, allowed);
    const double unit = b.scales.unit_shift, work = b.friction_limit * unit;
    for (std::size_t k = 0; k < a.steps.size(); ++k) {
        const auto &x = a.steps[k], &y = b.steps[k];
        EXPECT_NEAR(x.indentation / y.indentation, 1, allowed);
        EXPECT_NEAR((x.shift[0] - y.shift[0]) / unit, 0, allowed);
        EXPECT_NEAR((x.dissipation - y.dissipation) / work, 0, allowed);
        EXPECT_NEAR((x.material_dissipation - y.material_dissipation) / work, 0, allowed);
        EXPECT_NEAR(x.stored_energy / y.stored_energy, 1, allowed);
    }
}

/// A million times flatter under a millionth of the force: the same contact, strains of 1e-7. The
/// rounding of positions is then 1e-9 of d: a tolerance that can be reached.
Case flat(Case c) {
    c.indenter.radius *= 1e6;
    c.load.normal_force = 1e-6 * *c.load.normal_force;
    c.of<fem::Settings>().tolerance = 1e-6;
    return c;
}

TEST(FiniteStrainLimits, SmallStrainsAreTheLinearLayer) {
    Case c = flat(rolled_case(1.4e-3));
    const History strained = run(c);
    c.law = Case::Law::linear;
    c.of<fem::Settings>().tolerance = 1e-9;
    expect_equal(strained, run(c), 1e-6);
}

TEST(FiniteStrainLimits, SmallStrainsOfARelaxingLayerAreTheLinearOne) {
    Case c = flat(rolled_case(1.4e-3));
    c.relaxation = rubber;
    c.rolling->speed = 1e-3;
    c.load.press_time = .5;
    c.load.hold = 2;
    const History strained = run(c);
    c.law = Case::Law::linear;
    c.of<fem::Settings>().tolerance = 1e-9;
    expect_equal(strained, run(c), 1e-6);
}

/// Records of the case's path on this mesh, each step of this duration.
std::vector<contact::StepRecord> timed(const Case& c, const meshes::HexMesh& mesh,
                                       double duration) {
    const contact::LoadPath path = contact::make_load_path(c, *c.load.normal_force, 4.3e-3);
    StrainedModel model({.layer = LayerCondenser(c, {}).make(mesh),
                         .indenter = c.make_indenter(),
                         .rolling_radius = c.indenter.radius,
                         .friction = c.friction.law(),
                         .tolerance = of_fem_tolerance * c.of<fem::Settings>().tolerance,
                         .relaxation = c.relaxation.value_or(contact::Relaxation{})});
    std::vector<contact::StepRecord> records;
    for (const auto* steps : {&path.pressing, &path.loading, &path.period})
        for (contact::LoadStep step : *steps) {
            step.duration = duration;
            records.push_back(model.advance(step));
        }
    EXPECT_TRUE(model.audit().passed());
    return records;
}

void expect_equal(const std::vector<contact::StepRecord>& a,
                  const std::vector<contact::StepRecord>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double d = b[k].indentation;
        // Solutions of other stiffness, each to the tolerance of 1e-10 times an amplification.
        EXPECT_NEAR(a[k].indentation / d, 1, 1e-8);
        EXPECT_NEAR((a[k].shift[0] - b[k].shift[0]) / d, 0, 1e-7);
        EXPECT_NEAR(a[k].stored_energy / b[k].stored_energy, 1, 1e-8);
        EXPECT_NEAR(a[k].material_dissipation / b[k].stored_energy, 0, 1e-12);
    }
}

TEST(FiniteStrainLimits, InfinitelySlowIsTheRelaxedLayer) {
    Case c = rolled_case(coarse);
    const meshes::HexMesh mesh = make_mesh(c, {});
    const auto elastic = timed(c, mesh, contact::infinity);
    c.relaxation = rubber;
    expect_equal(timed(c, mesh, contact::infinity), elastic);
}

TEST(FiniteStrainLimits, SuddenIsTheUnrelaxedLayer) {
    Case c = rolled_case(coarse);
    const meshes::HexMesh mesh = make_mesh(c, {});
    c.relaxation = rubber;
    const auto sudden = timed(c, mesh, 0);
    c.relaxation.reset();
    c.substrate.young *= rubber.instantaneous_ratio();
    expect_equal(sudden, timed(c, mesh, 0));
}

TEST(FiniteStrainLimits, HalfAndWholeModelAgree) {
    Case c = rolled_case(coarse);
    const History half = run(c);
    c.rolling->angle = 1e-9;  // no plane of symmetry any more, for the program
    const History whole = run(c);
    expect_equal(half, whole, 1e-9);
}

// A model that reads a state goes on as the one that wrote it, to the last bit.
TEST(FiniteStrainLimits, GoesOnFromAWrittenState) {
    for (const bool relaxes : {false, true}) {
        Case c = rolled_case(coarse);
        if (relaxes) c.relaxation = rubber;
        c.rolling->speed = 1e-3;
        const contact::LoadPath path = contact::make_load_path(c, 21.1, 4.3e-3);
        const auto first = make_layer_model(c), second = make_layer_model(c);
        for (const auto* steps : {&path.pressing, &path.loading})
            for (const auto& step : *steps) first->advance(step);
        first->start_limit();
        first->start_period();
        first->advance(path.period[0]);
        second->read_state(first->write_state());
        EXPECT_EQ(second->write_state(), first->write_state());
        for (int k : {1, 2}) {
            const auto a = first->advance(path.period[k]), b = second->advance(path.period[k]);
            EXPECT_EQ(a.indentation, b.indentation);
            EXPECT_EQ(a.shift, b.shift);
        }
        EXPECT_EQ(second->write_state(), first->write_state());
        EXPECT_EQ(second->limit_tangential_ratio(), first->limit_tangential_ratio());
    }
}

}  // namespace
}  // namespace tricontact::fem::finite_strain_limits_test
