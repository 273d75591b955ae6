// What the report of a rig says, and of which rigs it must not say it.
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "contact/base/error.h"
#include "experiments/assumptions/assumption_list.h"
#include "experiments/assumptions/rolling_parts.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::sentences_test {
namespace {

using experiments::Rig;
using experiments::Standing;

Rig thesis_sphere() {
    return rig_file("sphere_parallel");
}
Rig thesis_cylinder() {
    return rig_file("cylinder_parallel");
}

/// Steel ball of 15 mm on 3 mm of polyurethane.
Rig ball_on_polyurethane() {
    Rig rig;
    rig.R = 15e-3;
    rig.E_1 = 206e9;
    rig.nu_1 = 0.3;
    rig.b = 3e-3;
    rig.E_2 = 25e6;
    rig.nu_2 = 0.48;
    rig.rho = 1200;
    rig.eta = 3e3;
    rig.mu = 0.8;
    rig.F_N = 12;
    rig.v = 1e-3;
    rig.w = 0.2;
    rig.f_1 = 30;
    return rig;
}

std::string elastic(const Rig& rig) {
    return experiments::elastic_substrate(rig).consequence;
}
std::string ends(const Rig& rig) {
    return experiments::long_cylinder(rig).consequence;
}
std::string drive(const Rig& rig) {
    return experiments::quasi_static_drive(rig).consequence;
}
std::string contact_of(const Rig& rig) {
    return experiments::half_space(rig).consequence;
}

/// What is said where the thesis could be meant; not the slow contact of a sphere.
std::string remarks(const Rig& rig) {
    const auto contact =
        rig.L.is_known() ? experiments::half_space_of_line(rig) : experiments::half_space(rig);
    std::string text = contact.claim + '\n' + elastic(rig);
    if (rig.L.is_known()) text += '\n' + ends(rig);
    return text;
}

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(RigSentences, RemarksOnTheThesisAreMadeOfItsOwnRigsOnly) {
    for (const char* name : {"sphere_parallel", "sphere_perpendicular", "cylinder_parallel"})
        EXPECT_TRUE(experiments::is_thesis_rig(rig_file(name))) << name;
    const std::string square = "(5.1.16) has a square too many", rule = "b >= D_c suffices",
                      exponent = "-0.23", ends = "its ends are not measured";
    EXPECT_TRUE(says(remarks(thesis_sphere()), square));
    EXPECT_TRUE(says(remarks(thesis_sphere()), rule));
    EXPECT_TRUE(says(remarks(thesis_cylinder()), exponent));
    EXPECT_TRUE(says(remarks(thesis_cylinder()), ends));
    // One datum off, and the rig is another.
    const std::function<void(Rig&)> changes[] = {
        [](Rig& r) { r.R.value *= 1.01; }, [](Rig& r) { r.b.value *= 1.01; },
        [](Rig& r) { r.E_2.value *= 1.01; }, [](Rig& r) { r.mu.value *= 1.01; },
        [](Rig& r) { r.F_N.value *= 1.01; }};
    for (const auto& change : changes)
        for (Rig rig : {thesis_sphere(), thesis_cylinder()}) {
            change(rig);
            EXPECT_FALSE(experiments::is_thesis_rig(rig));
            const std::string words = remarks(rig);
            for (const std::string& remark : {square, rule, exponent, ends})
                EXPECT_FALSE(says(words, remark)) << words;
        }
}

TEST(RigSentences, TheMaxwellElementIsThatOfTheFileOrNotThere) {
    Rig rig = thesis_sphere();
    rig.G_ratio = {};
    EXPECT_EQ(experiments::elastic_substrate(rig).background.size(), 2U);  // G_1 and v_max
    EXPECT_FALSE(says(elastic(rig), "5.1.16"));
    // Twice as stiff: half the relaxation time, so half of what the print has.
    Rig stiffer = thesis_sphere();
    stiffer.G_ratio.value *= 2;
    const auto printed = [](const Rig& one) {
        const experiments::Calculation c = experiments::elastic_substrate(one).background.back();
        EXPECT_EQ(c.name, "loss_modulus_as_printed");
        return c.result.value;
    };
    EXPECT_NEAR(printed(stiffer) / printed(thesis_sphere()), 0.5, 1e-9);
}

TEST(RigSentences, SpeedsOfAnySizeAreReadable) {
    Rig rig = ball_on_polyurethane();
    // omega eta/G_1 = 0.01 at v_max: 2 pi v/(4 w a) eta = 0.01 E/(2 (1 + nu))
    const double modulus = 1 / ((1 - 0.48 * 0.48) / 25e6 + (1 - 0.09) / 206e9);
    const double a = std::cbrt(3 * 12 * 15e-3 / (4 * modulus));  // Hertz
    const double wanted = 0.202e-3;
    rig.eta.value = 0.01 * 25e6 / (2 * 1.48) * 4 * 0.2 * a / (2 * std::numbers::pi * wanted);
    const std::string words = elastic(rig);
    EXPECT_TRUE(says(words, "up to a drive speed of 202 µm/s they stay below 1 %")) << words;
    // The drive is five times as fast: 5 %.
    EXPECT_TRUE(says(words, "at most 5.0 % of the elastic ones")) << words;
}

TEST(RigSentences, TheEffectOfCouplingOnTheShiftDecides) {
    Rig rig = ball_on_polyurethane();
    rig.nu_2 = {0.48025};  // (1 - 2 nu)/(2 (1 - nu)) = 0.038 under a rigid ball
    const experiments::StaticShift third = [](const Rig& /*rig*/, bool coupled) {
        return coupled ? 1.3e-4 : 1e-4;
    };
    const std::string words = experiments::uncoupled(rig, third).consequence;
    EXPECT_TRUE(says(words, "would couple by |beta| = 0.038")) << words;
    EXPECT_EQ(experiments::uncoupled(rig, third).standing(), experiments::Standing::violated);
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
    EXPECT_EQ(open.standing(), experiments::Standing::not_testable);
    // Nobody computed it: nothing is said of it.
    EXPECT_FALSE(says(experiments::uncoupled(rig, {}).consequence, "static shift"));
}

TEST(RigSentences, FiniteStrainsAreToldWithinTheRangeOfTheirFit) {
    const auto error = [](const experiments::Assumption& a, std::size_t i) {
        return a.criteria.at(i).calculation.result;
    };
    // Runs by both laws: U_stat 1.69 to 1.76 %, d -0.21 %.
    const experiments::Assumption thesis = experiments::small_strains(thesis_sphere());
    EXPECT_EQ(thesis.standing(), experiments::Standing::holds);
    EXPECT_NEAR(error(thesis, 0).value, .0173, .0010);
    EXPECT_NEAR(error(thesis, 1).value, .0021, .0002);
    EXPECT_TRUE(says(thesis.consequence, "% too high, the indentation 0.21")) << thesis.consequence;
    // One that the fit has not seen: 2.86 %, -0.49 %.
    Rig other = thesis_sphere();
    other.R = {25e-3};
    other.b = {12e-3};
    other.E_2 = {3e6};
    other.F_N = {10};
    other.mu = {.4};
    const experiments::Assumption thick = experiments::small_strains(other);
    EXPECT_NEAR(error(thick, 0).value, .0286, .0015);
    EXPECT_NEAR(error(thick, 1).value, .0049, .0003);
    EXPECT_LT(error(thick, 0).standard_error, .002);
}

TEST(RigSentences, FiniteStrainsAreNotToldBeyondTheirFit) {
    const auto open = [](experiments::Inputs::Member number, double value, const char* named) {
        Rig rig = thesis_sphere();
        rig.*number = value;
        const experiments::Assumption a = experiments::small_strains(rig);
        EXPECT_EQ(a.standing(), experiments::Standing::not_testable) << named;
        EXPECT_TRUE(a.consequence.empty()) << a.consequence;
        EXPECT_TRUE(a.criteria.empty()) << named;
        ASSERT_EQ(a.missing.size(), 1) << named;
        EXPECT_TRUE(says(a.missing.front(), named)) << a.missing.front();
    };
    open(&Rig::b, 3e-3, "an estimate for a/b = 1.");
    open(&Rig::b, 80e-3, "an estimate for a/b = 0.05");
    open(&Rig::mu, 1.2, "an estimate for mu = 1.20");
    open(&Rig::nu_2, .45, "an estimate for nu_2 = 0.450");
    open(&Rig::R, 5e-3, "an estimate for a/R = 0.");
    open(&Rig::E_1, 50e6, "no theory here for an elastic indenter");
}

TEST(RigSentences, ARollerThatIsNotRigidIsNotComparedWithALayerUnderARigidOne) {
    Rig rig = ball_on_polyurethane();
    rig.E_1 = {50e6};
    const auto report = experiments::check_rig(
        rig, [](const Rig& /*rig*/, bool /*coupled*/) -> double { throw "not asked"; });
    for (const char* name : {"half_space", "fitted_constants", "uncoupled", "small_strains"})
        EXPECT_NE(assumption_of(report, name).standing(), Standing::holds) << name;
    const auto& half_space = assumption_of(report, "half_space");
    EXPECT_FALSE(says(half_space.consequence, "true one")) << half_space.consequence;
    EXPECT_TRUE(says(half_space.consequence, "not rigid")) << half_space.consequence;
    EXPECT_FALSE(half_space.missing.empty());
    EXPECT_FALSE(experiments::force_curves(rig));
    EXPECT_TRUE(assumption_of(report, "fitted_constants").consequence.empty());
    // Steel is rigid beside it.
    EXPECT_TRUE(says(contact_of(ball_on_polyurethane()), "true one"));
}

TEST(RigSentences, InertiaDecidesFromTheEigenfrequencyOn) {
    Rig rig = thesis_sphere();
    EXPECT_TRUE(says(
        drive(rig), "changes the motion by 0.0099 %: the fastest oscillation is 100 times slower"));
    rig.f_1 = {0.1};  // f_0 = 0.219 Hz
    const std::string words = drive(rig);
    EXPECT_TRUE(says(words, "2.19 times as fast")) << words;
    EXPECT_FALSE(says(words, "slower")) << words;
}

TEST(RigSentences, MeasuredSizesWithoutAnErrorAreNotJudged) {
    Rig rig = thesis_sphere();
    rig.D_c = {9e-3};
    const std::string words = contact_of(rig);
    EXPECT_TRUE(says(words, "whose error is not given")) << words;
    for (const char* verdict : {"fits", "does not distinguish the two"})
        EXPECT_FALSE(says(words, verdict)) << words;
}

TEST(RigSentences, EndsOfACylinderAreThoseOfItsMaterials) {
    Rig rig = thesis_cylinder();
    EXPECT_TRUE(says(ends(rig), "as under the edge of a rigid body"));
    rig.E_1 = {3.6e6};  // alpha about 0: -0.23
    std::string words = ends(rig);
    EXPECT_TRUE(says(words, "growing as y^−0.2")) << words;
    EXPECT_FALSE(says(words, "rigid")) << words;
    rig.E_1 = {1e-3};  // the substrate is rigid: no singularity
    EXPECT_FALSE(says(ends(rig), "sharp end"));
    rig.nu_2 = {0};
    words = ends(rig);
    EXPECT_TRUE(says(words, "keep the pressure")) << words;
    EXPECT_FALSE(says(words, "lose")) << words;
    Rig barrel = thesis_cylinder();
    barrel.L = {5e-3};
    words = ends(barrel);
    EXPECT_TRUE(says(words, "too short")) << words;
    EXPECT_FALSE(says(words, "of the load inwards")) << words;
}

TEST(RigSentences, AThickLayerIsHertzToItsDigits) {
    Rig rig = thesis_sphere();
    rig.b = {4.0};
    const std::string words = contact_of(rig);
    EXPECT_FALSE(says(words, " 0.0 %")) << words;
    EXPECT_TRUE(says(words, "below Hertz")) << words;
}

TEST(RigSentences, WalkingRigsSayWhatTheyKnow) {
    auto rig = rig_file("micro_walking_set_5");
    const auto diameter = [](const Rig& one) {
        const auto report = experiments::check_rig(one);
        const auto& a = assumption_of(report, "contact_diameter");
        return a.claim + ". " + a.consequence;
    };
    EXPECT_TRUE(says(diameter(rig), "Three ways"));
    EXPECT_TRUE(says(diameter(rig), "not fresh edges"));
    rig.D_wear = {};
    EXPECT_TRUE(says(diameter(rig), "Two ways"));
    rig.Omega_exp = rig.omega_sim = rig.tau = rig.f_samp = {};
    rig.D_c = {0.3e-3};  // Hertz': 0.31 mm
    EXPECT_TRUE(says(diameter(rig), "Hertz' formula finds"));
    EXPECT_FALSE(says(diameter(rig), "not fresh edges"));
    // Without standard errors the error of the stiffness is unavailable.
    rig.D_c = {1.8e-3};
    const auto stiffness = assumption_of(experiments::check_rig(rig), "known_stiffness");
    EXPECT_EQ(stiffness.standing(), Standing::not_testable);
    EXPECT_TRUE(stiffness.consequence.empty()) << stiffness.consequence;
}

}  // namespace
}  // namespace tricontact::sentences_test
