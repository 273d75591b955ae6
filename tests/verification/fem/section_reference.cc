// Bodies of a finite size: references by finite elements of the section beside numbers of an
// independent program and of Johnson's formula, and results of other codes beside them.

#include <gtest/gtest.h>

#include <cmath>

#include "app/benchmark/benchmark_case.h"
#include "benchmarks/problems/problem.h"
#include "benchmarks/problems/target_reference.h"
#include "tests/unit/benchmarks/foreign.h"

namespace tricontact::benchmarks {
namespace section_reference_test {

namespace keys = quantity_keys;

/// Computed, or kept by the program of the same sources: its pages of the problems have the same
/// ones.
Reference reference_of_problem(const std::string& name) {
    return app::reference_of_case(required_problem(name).make_case(), 1, contact::silent);
}

const Reference& hemisphere() {
    static const Reference one = reference_of_problem("hemisphere");
    return one;
}

/// Every number that was published as the solution, within both bars and 1e-4: those of meshes.
void expect_targets(const Reference& reference, const std::string& name) {
    for (const Target& target : required_problem(name).targets) {
        if (!target.is_solution) continue;
        const ReferenceValue* value = reference.find(target.key);
        ASSERT_TRUE(value) << name << ": " << target.key;
        EXPECT_NEAR(value->value, target.value, target.bar + 1e-4 * std::abs(target.value))
            << name << ": " << target.key;
        EXPECT_LT(value->grid, 2e-4 * std::abs(value->value)) << name << ": " << target.key;
    }
}

TEST(SectionReference, NumbersOfAnIndependentProgram) {
    expect_targets(hemisphere(), "hemisphere");
    expect_targets(reference_of_problem("hemisphere_on_layer"), "hemisphere_on_layer");
    expect_targets(reference_of_problem("ball_between_plates"), "ball_between_plates");
}

TEST(SectionReference, JohnsonsCylinderBetweenPlates) {
    const Reference r = reference_of_problem("cylinder_between_plates");
    EXPECT_EQ(r.geometry, Geometry::plane);
    expect_targets(r, "cylinder_between_plates");
}

// Contact radii of nodes are known within a half of their distance.
TEST(SectionReference, RecedingLayerOfKeerDundursAndTsai) {
    const Reference r = reference_of_problem("receding_layer");
    EXPECT_NEAR(r.find(keys::contact_radius)->value, 1.324165 * 2e-3, .005 * 2.648e-3);
    EXPECT_NEAR(r.find(keys::peak_pressure)->value, .713080 * 12.5 / 2e-3, 5e-4 * 4457);
    EXPECT_FALSE(r.find(keys::indentation));
}

TEST(SectionReference, NafemsPunchEndsBeyondItsFlat) {
    const Reference punch = reference_of_problem("nafems_punch");
    EXPECT_EQ(punch.find(keys::normal_force)->bar(), 0);
    EXPECT_NEAR(punch.find(keys::contact_radius)->value, .0404, .0004);  // half an element of 48
}

// Cattaneo (1938): c/a = (1 - f)^(1/2), within two nodes, which are a/64 apart, at either end.
TEST(SectionReference, CattaneosStickZoneBetweenFiniteBodies) {
    const Reference r = reference_of_problem("cattaneo_two_cylinders");
    EXPECT_NEAR(r.find(keys::stick_area)->value / r.find(keys::contact_area)->value, std::sqrt(.5),
                2. / 96);
    EXPECT_TRUE(r.is_prescribed(keys::tangential_force));
    EXPECT_LT(r.find(keys::shift)->bar(), 1e-3 * r.find(keys::shift)->value);
}

// Spence (1975) at beta = 1/6. A finite hemisphere sticks within a little more.
TEST(SectionReference, SpencesStickZoneBetweenTwoBodies) {
    const Reference r = reference_of_problem("spence_two_bodies");
    EXPECT_NEAR(std::sqrt(r.find(keys::stick_area)->value / r.find(keys::contact_area)->value), .7,
                .03);
}

// Carter (1926) as half-spaces: creep 1 - (1 - f)^(1/2) in mu a/R, stick (1 - f)^(1/2) of the
// contact; a/R = .05, whose square is what finite bodies may differ by.
TEST(SectionReference, CartersCreepIsTheMeanOfBothDirections) {
    const Reference r = reference_of_problem("carter_two_cylinders");
    const ReferenceValue& creep = *r.find(keys::creepage);
    EXPECT_NEAR(creep.value / (.5 * .05), 1 - std::sqrt(.5), .0025);
    EXPECT_LT(creep.bar(), .01 * creep.value);
    const ReferenceValue &stick = *r.find(keys::stick_area), &all = *r.find(keys::contact_area);
    EXPECT_NEAR(stick.value / all.value, std::sqrt(.5), stick.bar() / all.value + .0025);
}

TEST(SectionReference, RefusesToReadCreepFromShortLegs) {
    contact::Case c = required_problem("carter_two_cylinders").make_case();
    for (auto& row : c.prescribed_path->rows) row.offset[0] /= 2;
    EXPECT_THROW(reference(c, contact::ModelRunner(app::model_makers(), 1)), contact::InputError);
}

// A hole is no flat substrate, and a pin in it no half-space on one.
TEST(SectionReference, RefusesHoles) {
    contact::Case c = required_problem("cylinder_between_plates").make_case();
    c.has_rigid_substrate = false;
    c.substrate_shape = contact::Case::SubstrateShape::hole;
    EXPECT_THROW(reference(c, contact::ModelRunner(app::model_makers(), 1)), contact::InputError);
    c.indenter.body.reset();
    EXPECT_THROW(reference(c, contact::ModelRunner(app::model_makers(), 1)), contact::InputError);
}

// dF/dd of this force: two runs of the independent program at other depths are not there, so the
// exponent between d = .1 and 1 mm of its table, 1.5806, bounds it from above, Hertz' from below.
TEST(SectionReference, FieldsCarryTheForceAndTheStiffnessFits) {
    const Reference& r = hemisphere();
    const double force = r.find(keys::normal_force)->value, a = r.contact_radius;
    EXPECT_NEAR(r.fields->load_within(a), force, 1e-9 * force);
    // Under a paraboloid of pressure (1 - (1 - 1/4)^(3/2)) of the force is within a/2.
    EXPECT_NEAR(r.fields->load_within(a / 2) / force, 1 - std::pow(.75, 1.5), 2e-3);
    EXPECT_NEAR(r.fields->at(0, 0).pressure, .143057e6, 20);
    EXPECT_EQ(r.fields->at(1.01 * a, 0).pressure, 0);
    const double exponent = r.find(keys::normal_stiffness)->value * 1e-4 / force;
    EXPECT_GT(exponent, 1.5);
    EXPECT_LT(exponent, 1.5806);
}

// A number beside those of the elements widens the bar by what they differ.
TEST(SectionReference, TargetsAreModelsBesideIt) {
    Reference r = hemisphere();
    const double before = r.find(keys::contact_radius)->model;
    add_targets(r, required_problem("hemisphere"));
    EXPECT_EQ(before, 0);
    EXPECT_NEAR(r.find(keys::contact_radius)->model,
                std::abs(r.find(keys::contact_radius)->value - 1.0246e-3), 1e-12);
    EXPECT_EQ(r.find(keys::indentation)->bar(), 0);
}

TEST(SectionReference, GetfemPasses) {
    Submission s = foreign::submission({"getfem_q2_hemisphere_4.csv", "getfem_q2_hemisphere_8.csv",
                                        "getfem_q2_hemisphere_16.csv"});
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    const Comparison c = compare(s, hemisphere());
    EXPECT_EQ(c.standing, Standing::pass);
    EXPECT_LT(std::abs(foreign::number(c, "normal_force").difference), 3e-4);
    EXPECT_LT(std::abs(foreign::number(c, "peak_pressure").difference), 1e-3);
}

// K = 310 MPa/mm: its own runs with ten times as much differ by nine tenths of .353 %.
TEST(SectionReference, PenaltyExplainsFreefem) {
    Submission s =
        foreign::submission({"freefem_p2_hemisphere_4.csv", "freefem_p2_hemisphere_8.csv",
                             "freefem_p2_hemisphere_16.csv"});
    s.contact.kinematics = ContactMethod::Kinematics::undeformed;
    s.contact.stiffness = 310e9;
    const Comparison c = compare(s, hemisphere());
    const ComparedNumber& force = foreign::number(c, "normal_force");
    EXPECT_EQ(c.standing, Standing::pass);
    EXPECT_NEAR(force.difference, -.00353, 1e-4);
    EXPECT_LT(std::abs(force.left()), 2e-4);
}

// Hertz' own number of this sphere is none of the problem: 7.1 % too low.
TEST(SectionReference, HertzFails) {
    Submission s = foreign::submission({"getfem_q2_hemisphere_4.csv", "getfem_q2_hemisphere_8.csv",
                                        "getfem_q2_hemisphere_16.csv"});
    for (MeshField& mesh : s.meshes) {
        mesh.totals["normal_force"].value *= .29304 / .31530;
        for (FieldColumn& column : mesh.columns)
            if (column.meaning == Meaning::pressure)
                for (double& p : column.values) p *= .29304 / .31530;
    }
    EXPECT_EQ(compare(s, hemisphere()).standing, Standing::fail);
}

TEST(SectionReference, RefusesFriction) {
    contact::Case c = required_problem("hemisphere").make_case();
    c.contact.coupling = true;
    c.load.tangential_ratio = .5;
    EXPECT_THROW(reference(c, contact::ModelRunner(app::model_makers(), 1)), contact::InputError);
}

}  // namespace section_reference_test
}  // namespace tricontact::benchmarks
