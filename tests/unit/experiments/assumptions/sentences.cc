// What the report of a rig says, and of which rigs it must not say it.
#include <cmath>
#include <functional>
#include <numbers>

#include "contact/error.h"
#include "experiments/assumptions/rolling_parts.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::sentences_test {
namespace {

using experiments::RollingRig;
using experiments::Standing;
using experiments::WalkingRig;

RollingRig thesis_sphere() {
    return std::get<RollingRig>(rig_file("sphere_parallel"));
}
RollingRig thesis_cylinder() {
    return std::get<RollingRig>(rig_file("cylinder_parallel"));
}

/// Steel ball of 15 mm on 3 mm of polyurethane.
RollingRig ball_on_polyurethane() {
    RollingRig rig;
    rig.roller = {RollingRig::Shape::sphere, {15e-3}, {}, {206e9}, {0.3}};
    rig.substrate = {{3e-3}, {25e6}, {0.48}, statistics::Estimate{1200}, statistics::Estimate{3e3},
                     {}};
    rig.friction_coefficient = {0.8};
    rig.normal_force = {12};
    rig.drive = {{1e-3}, {0.2}, {}, statistics::Estimate{30}};
    return rig;
}

std::string elastic(const RollingRig& rig) {
    return experiments::elastic_substrate(rig).consequence;
}
std::string ends(const RollingRig& rig) {
    return experiments::long_cylinder(rig).consequence;
}
std::string drive(const RollingRig& rig) {
    return experiments::quasi_static_drive(rig).consequence;
}
std::string contact_of(const RollingRig& rig) {
    return experiments::half_space(rig).consequence;
}

/// What is said where the thesis could be meant; not the slow contact of a sphere.
std::string remarks(const RollingRig& rig) {
    const auto contact =
        rig.roller.length ? experiments::half_space_of_line(rig) : experiments::half_space(rig);
    std::string text = contact.claim + '\n' + elastic(rig);
    if (rig.roller.length) text += '\n' + ends(rig);
    return text;
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(RigSentences, RemarksOnTheThesisAreMadeOfItsOwnRigsOnly) {
    for (const char* name : {"sphere_parallel", "sphere_perpendicular", "cylinder_parallel"})
        EXPECT_TRUE(experiments::is_thesis_rig(std::get<RollingRig>(rig_file(name)))) << name;
    const std::string square = "(5.1.16) has a square too many", rule = "b >= D_c suffices",
                      exponent = "-0.23", ends = "its ends are not measured";
    EXPECT_TRUE(says(remarks(thesis_sphere()), square));
    EXPECT_TRUE(says(remarks(thesis_sphere()), rule));
    EXPECT_TRUE(says(remarks(thesis_cylinder()), exponent));
    EXPECT_TRUE(says(remarks(thesis_cylinder()), ends));
    // One datum off, and the rig is another.
    const std::function<void(RollingRig&)> changes[] = {
        [](RollingRig& r) { r.roller.radius.value *= 1.01; },
        [](RollingRig& r) { r.substrate.thickness.value *= 1.01; },
        [](RollingRig& r) { r.substrate.young.value *= 1.01; },
        [](RollingRig& r) { r.friction_coefficient.value *= 1.01; },
        [](RollingRig& r) { r.normal_force.value *= 1.01; }};
    for (const auto& change : changes)
        for (RollingRig rig : {thesis_sphere(), thesis_cylinder()}) {
            change(rig);
            EXPECT_FALSE(experiments::is_thesis_rig(rig));
            const std::string words = remarks(rig);
            for (const std::string& remark : {square, rule, exponent, ends})
                EXPECT_FALSE(says(words, remark)) << words;
        }
}

TEST(RigSentences, TheMaxwellElementIsThatOfTheFileOrNotThere) {
    RollingRig rig = thesis_sphere();
    rig.substrate.maxwell_ratio.reset();
    EXPECT_EQ(experiments::elastic_substrate(rig).background.size(), 2U);  // G_1 and v_max
    EXPECT_FALSE(says(elastic(rig), "5.1.16"));
    // Twice as stiff: half the relaxation time, so half of what the print has.
    RollingRig stiffer = thesis_sphere();
    stiffer.substrate.maxwell_ratio->value *= 2;
    const auto printed = [](const RollingRig& one) {
        const experiments::Calculation c = experiments::elastic_substrate(one).background.back();
        EXPECT_EQ(c.name, "loss_modulus_as_printed");
        return c.result.value;
    };
    EXPECT_NEAR(printed(stiffer) / printed(thesis_sphere()), 0.5, 1e-9);
}

TEST(RigSentences, SpeedsOfAnySizeAreReadable) {
    RollingRig rig = ball_on_polyurethane();
    // omega eta/G_1 = 0.01 at v_max: 2 pi v/(4 w a) eta = 0.01 E/(2 (1 + nu))
    const double modulus = 1 / ((1 - 0.48 * 0.48) / 25e6 + (1 - 0.09) / 206e9);
    const double a = std::cbrt(3 * 12 * 15e-3 / (4 * modulus));  // Hertz
    const double wanted = 0.202e-3;
    rig.substrate.viscosity->value =
        0.01 * 25e6 / (2 * 1.48) * 4 * 0.2 * a / (2 * std::numbers::pi * wanted);
    const std::string words = elastic(rig);
    EXPECT_TRUE(says(words, "up to a drive speed of 202 µm/s they stay below 1 %")) << words;
    // The drive is five times as fast: 5 %.
    EXPECT_TRUE(says(words, "at most 5.0 % of the elastic ones")) << words;
}

TEST(RigSentences, TheEffectOfCouplingOnTheShiftDecides) {
    RollingRig rig = ball_on_polyurethane();
    rig.substrate.poisson = {0.48025};  // (1 - 2 nu)/(2 (1 - nu)) = 0.038 under a rigid ball
    const experiments::StaticShift third = [](const RollingRig& /*rig*/, bool coupled) {
        return coupled ? 1.3e-4 : 1e-4;
    };
    const std::string words = experiments::uncoupled(rig, third).consequence;
    EXPECT_TRUE(says(words, "would couple by |beta| = 0.038")) << words;
    EXPECT_EQ(experiments::uncoupled(rig, third).standing(), experiments::Standing::fails);
    EXPECT_TRUE(says(words, "changes the static shift by 30 %.")) << words;
    EXPECT_FALSE(says(words, "only"));
    const std::string rubber = experiments::uncoupled(thesis_sphere(), [](const auto&, bool on) {
                                   return on ? 0.15150e-3 : 0.15108e-3;
                               }).consequence;
    EXPECT_TRUE(says(rubber, "by 0.28 % only")) << rubber;
    // What rounding leaves is no effect, what does not converge is not known.
    const std::string none = experiments::uncoupled(rig, [](const auto&, bool on) {
                                 return on ? 1e-4 : (1 + 1e-9) * 1e-4;
                             }).consequence;
    EXPECT_TRUE(says(none, "by less than 0.001 %.")) << none;
    // |beta| = 0.038 alone is no reason: an effect of .03 % lets the assumption hold.
    EXPECT_EQ(
        experiments::uncoupled(rig, [](const auto&, bool on) { return on ? 1.0003e-4 : 1e-4; })
            .standing(),
        experiments::Standing::holds);
    const experiments::Assumption open = experiments::uncoupled(
        rig, [](const auto&, bool) -> double { throw contact::NotConverged("no end"); });
    EXPECT_FALSE(says(open.consequence, "static shift")) << open.consequence;
    EXPECT_FALSE(open.missing.empty());
    EXPECT_EQ(open.standing(), experiments::Standing::cannot_tell);
    // Nobody computed it: nothing is said of it.
    EXPECT_FALSE(says(experiments::uncoupled(rig, {}).consequence, "static shift"));
}

TEST(RigSentences, ARollerThatIsNotRigidIsNotComparedWithALayerUnderARigidOne) {
    RollingRig rig = ball_on_polyurethane();
    rig.roller.young = {50e6};
    const auto report = experiments::check_rig(
        rig, [](const RollingRig& /*rig*/, bool /*coupled*/) -> double { throw "not asked"; });
    for (const char* name : {"half_space", "fitted_constants", "uncoupled"})
        EXPECT_NE(assumption_of(report, name).standing(), Standing::holds) << name;
    const auto& half_space = assumption_of(report, "half_space");
    EXPECT_FALSE(says(half_space.consequence, "true one")) << half_space.consequence;
    EXPECT_TRUE(says(half_space.consequence, "not rigid")) << half_space.consequence;
    EXPECT_FALSE(half_space.missing.empty());
    EXPECT_FALSE(report.curves);
    EXPECT_TRUE(assumption_of(report, "fitted_constants").consequence.empty());
    // Steel is rigid beside it.
    EXPECT_TRUE(says(contact_of(ball_on_polyurethane()), "true one"));
}

TEST(RigSentences, InertiaDecidesFromTheEigenfrequencyOn) {
    RollingRig rig = thesis_sphere();
    EXPECT_TRUE(says(
        drive(rig), "changes the motion by 0.0099 %: the fastest oscillation is 100 times slower"));
    rig.drive.eigenfrequency = statistics::Estimate{0.1};  // f_0 = 0.219 Hz
    const std::string words = drive(rig);
    EXPECT_TRUE(says(words, "2.19 times as fast")) << words;
    EXPECT_FALSE(says(words, "slower")) << words;
}

TEST(RigSentences, MeasuredSizesWithoutAnErrorAreNotJudged) {
    RollingRig rig = thesis_sphere();
    rig.measured_contact_size = statistics::Estimate{9e-3};
    const std::string words = contact_of(rig);
    EXPECT_TRUE(says(words, "whose error is not given")) << words;
    for (const char* verdict : {"fits", "cannot tell the two apart"})
        EXPECT_FALSE(says(words, verdict)) << words;
}

TEST(RigSentences, EndsOfACylinderAreThoseOfItsMaterials) {
    RollingRig rig = thesis_cylinder();
    EXPECT_TRUE(says(ends(rig), "as under the edge of a rigid body"));
    rig.roller.young = {3.6e6};  // alpha about 0: -0.23
    std::string words = ends(rig);
    EXPECT_TRUE(says(words, "growing as y^−0.2")) << words;
    EXPECT_FALSE(says(words, "rigid")) << words;
    rig.roller.young = {1e-3};  // the substrate is rigid: no singularity
    EXPECT_FALSE(says(ends(rig), "sharp end"));
    rig.substrate.poisson = {0};
    words = ends(rig);
    EXPECT_TRUE(says(words, "keep the pressure")) << words;
    EXPECT_FALSE(says(words, "lose")) << words;
    RollingRig barrel = thesis_cylinder();
    barrel.roller.length = statistics::Estimate{5e-3};
    words = ends(barrel);
    EXPECT_TRUE(says(words, "too short")) << words;
    EXPECT_FALSE(says(words, "of the load inwards")) << words;
}

TEST(RigSentences, AThickLayerIsHertzToItsDigits) {
    RollingRig rig = thesis_sphere();
    rig.substrate.thickness = {4.0};
    const std::string words = contact_of(rig);
    EXPECT_FALSE(says(words, " 0.0 %")) << words;
    EXPECT_TRUE(says(words, "below Hertz")) << words;
}

TEST(RigSentences, WalkingRigsSayWhatTheyKnow) {
    auto rig = std::get<WalkingRig>(rig_file("micro_walking_set_5"));
    const auto diameter = [](const WalkingRig& one) {
        const auto report = experiments::check_rig(one);
        const auto& a = assumption_of(report, "contact_diameter");
        return a.claim + ". " + a.consequence;
    };
    EXPECT_TRUE(says(diameter(rig), "Three ways"));
    EXPECT_TRUE(says(diameter(rig), "not fresh edges"));
    rig.contact.wear_diameter.reset();
    EXPECT_TRUE(says(diameter(rig), "Two ways"));
    rig.oscillation.reset();
    rig.contact.diameter = {0.3e-3};  // Hertz': 0.31 mm
    EXPECT_TRUE(says(diameter(rig), "Hertz' formula finds"));
    EXPECT_FALSE(says(diameter(rig), "not fresh edges"));
    // Without standard errors nobody knows how well the stiffness is known.
    rig.contact.diameter = {1.8e-3};
    const auto stiffness = assumption_of(experiments::check_rig(rig), "known_stiffness");
    EXPECT_EQ(stiffness.standing(), Standing::cannot_tell);
    EXPECT_TRUE(stiffness.consequence.empty()) << stiffness.consequence;
}

}  // namespace
}  // namespace tricontact::sentences_test
