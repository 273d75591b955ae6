// What assumptions do to what a rig measures, and a substrate with several branches of relaxation.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "experiments/assumptions/assumption_list.h"
#include "experiments/assumptions/measured_effect.h"
#include "experiments/assumptions/rolling_parts.h"
#include "experiments/rig_report/rig_report.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/hertz.h"

namespace tricontact::effects_test {
namespace {

using experiments::Measured;
using experiments::MeasuredEffect;
using experiments::Rig;

std::optional<MeasuredEffect> effect_of(const experiments::RigReport& report,
                                        const std::string& assumption, Measured measured) {
    for (const MeasuredEffect& one : report.effects)
        if (one.assumption == assumption && one.measured == measured) return one;
    return {};
}

/// The thesis' rig, of which anything may be measured.
Rig thesis_rig() {
    Rig rig = rig_file("sphere_parallel");
    rig.measured.clear();
    return rig;
}

/// With a model's shifts, and what heat does. Computed once.
const experiments::RigReport& thesis_report() {
    static const auto report = [] {
        Rig rig = thesis_rig();
        rig.k_th = {.2};
        rig.c_T = {3e-3};
        return experiments::check_rig(
            rig, [](const Rig&, bool coupled) { return coupled ? 99e-6 : 100e-6; });
    }();
    return report;
}

// d ln U/d ln F_T of 1 - (1 - f)^(2/3), whose derivative is 2/3 (1 - f)^(-1/3); central differences
// of second order leave 1e-9.
TEST(MeasuredEffects, SensitivityIsTheDerivativeOfTheShift) {
    for (const double f : {.05, .3, .56, .9}) {
        const double h = 1e-5;
        const double difference = std::log(theory::static_shift_ratio(f * (1 + h)) /
                                           theory::static_shift_ratio(f * (1 - h))) /
                                  (2 * h);
        EXPECT_NEAR(experiments::shift_sensitivity_to_force(f), difference, 1e-8) << f;
    }
    // A contact that sticks is a linear spring.
    EXPECT_NEAR(experiments::shift_sensitivity_to_force(1e-6), 1, 1e-6);
}

// The half-space's depth by Hertz' formula, over the layer's as the report has it.
TEST(MeasuredEffects, OfTheHalfSpaceAreBothTheoriesApart) {
    const auto& report = thesis_report();
    const auto depth = effect_of(report, "half_space", Measured::indentation);
    ASSERT_TRUE(depth);
    EXPECT_FALSE(depth->is_bound);
    const double hertz = value_of(report, "indentation"),
                 layer = value_of(report, "layer_indentation");
    EXPECT_NEAR(depth->relative.value, hertz / layer - 1, 1e-12);
    // docs/explanation/rig.md: the layer is far from a half-space.
    EXPECT_GT(depth->relative.value, .3);
    const auto radius = effect_of(report, "half_space", Measured::contact_radius);
    ASSERT_TRUE(radius);
    EXPECT_LT(std::abs(radius->relative.value), depth->relative.value);
}

// A layer of a hundred radii is a half-space: to a/b.
TEST(MeasuredEffects, OfTheHalfSpaceVanishOnThickLayers) {
    Rig rig = thesis_rig();
    rig.b = {.4};
    const auto report = experiments::check_rig(rig);
    for (const Measured measured :
         {Measured::static_shift, Measured::indentation, Measured::contact_radius})
        EXPECT_NEAR(effect_of(report, "half_space", measured)->relative.value, 0, .02);
}

// With the model's shift: Cattaneo and Mindlin's at 0.56 mu F_N over it.
TEST(MeasuredEffects, OfStaticShiftsAreThoseOfTheModel) {
    const Rig rig = thesis_rig();
    const auto& report = thesis_report();
    const double computed =
        value_of(report, "unit_shift") * rig.mu.value * theory::static_shift_ratio(.56);
    EXPECT_NEAR(effect_of(report, "half_space", Measured::static_shift)->relative.value,
                computed / 100e-6 - 1, 1e-12);
    EXPECT_NEAR(effect_of(report, "uncoupled", Measured::static_shift)->relative.value,
                100. / 99 - 1, 1e-12);
}

TEST(MeasuredEffects, AreThoseOnWhatIsMeasured) {
    Rig rig = thesis_rig();
    rig.measured = {Measured::contact_radius};
    const auto effects = experiments::effects_on_measured(rig, thesis_report().assumptions);
    EXPECT_FALSE(effects.empty());
    for (const MeasuredEffect& one : effects) EXPECT_EQ(one.measured, Measured::contact_radius);
}

/// Largest |U/U' - 1| of Cattaneo and Mindlin's shift, where U' is that of a friction, or force,
/// that differs by a part of it to either side.
double largest_change(double of_friction, double of_force) {
    const auto shift = [](double friction, double force) {
        return friction * (1 - std::pow(1 - .56 * force / friction, 2. / 3));
    };
    double largest = 0;
    for (const double side : {1., -1.})
        largest = std::max(
            largest,
            std::abs(shift(1, 1) / shift(1 + side * of_friction, 1 + side * of_force) - 1));
    return largest;
}

// mu that falls or rises by 4 % through heat. What "at most" says is no first order.
TEST(MeasuredEffects, OfHeatIsBoundedByTheShiftsOfBothFrictions) {
    const auto& report = thesis_report();
    const auto effect = effect_of(report, "no_heating", Measured::static_shift);
    ASSERT_TRUE(effect);
    EXPECT_TRUE(effect->is_bound);
    const double change = value_of(report, "heating_change");
    EXPECT_NEAR(effect->relative.value, largest_change(change, 0), 1e-12);
    EXPECT_GT(effect->relative.value, change * (experiments::shift_sensitivity_to_force(.56) - 1));
}

// A contact that touches all over has hardly any friction left: at 0.56 mu F_N it slides. The first
// order said 16 %.
TEST(MeasuredEffects, OfFrictionThatIsGoneHaveNoBound) {
    Rig rig = thesis_rig();
    const auto assumption = [](double saturation) {
        return std::vector<experiments::Assumption>{
            {.name = "unsaturated_contact",
             .criteria = {{{.name = "saturation", .result = {saturation, .01}},
                           experiments::Criterion::Relation::at_most,
                           .05,
                           ""}}}};
    };
    const auto none = experiments::effects_on_measured(rig, assumption(.99));
    ASSERT_EQ(none.size(), 1u);
    EXPECT_TRUE(std::isinf(none[0].relative.value));
    EXPECT_EQ(experiments::text_of(none[0]),
              "not bounded (at F_T = 0.56 mu F_N the contact might slide)");
    const auto some = experiments::effects_on_measured(rig, assumption(.3));
    EXPECT_NEAR(some[0].relative.value, largest_change(.3, 0), 1e-12);
    const auto slides = experiments::effects_on_measured(rig, assumption(.441));  // 0.56/0.559
    EXPECT_TRUE(std::isinf(slides[0].relative.value));
}

// A slope of half a degree beside F_T, and sides that add to d.
TEST(MeasuredEffects, OfSidesAndSlopesFollowFromTheirCriteria) {
    Rig rig = thesis_rig();
    const auto calculation = [](const char* name, double value, double error) {
        return experiments::Calculation{.name = name, .result = {value, error}};
    };
    const std::vector<experiments::Assumption> assumptions{
        {.name = "far_edges",
         .criteria = {{calculation("side_effect", .06, .01),
                       experiments::Criterion::Relation::at_most, .05, ""}}},
        {.name = "level_surface",
         .criteria = {{calculation("tilt_load", .02, .005),
                       experiments::Criterion::Relation::at_most, .05, ""}}}};
    const auto effects = experiments::effects_on_measured(rig, assumptions);
    ASSERT_EQ(effects.size(), 2u);
    EXPECT_EQ(effects[0].measured, Measured::indentation);
    EXPECT_NEAR(effects[0].relative.value, 1 / 1.06 - 1, 1e-12);
    EXPECT_EQ(effects[1].measured, Measured::static_shift);
    EXPECT_TRUE(effects[1].is_bound);
    EXPECT_NEAR(effects[1].relative.value, largest_change(0, .025 / .56), 1e-12);
}

TEST(MeasuredEffects, AreToldWithSignOrAsBounds) {
    const auto text = [](double relative, double error, bool is_bound) {
        return experiments::text_of(
            MeasuredEffect{"half_space", Measured::indentation, {relative, error}, is_bound});
    };
    EXPECT_EQ(text(.2312, .008, false), "+23.1 ± 0.8 %");
    EXPECT_EQ(text(-.378, 0, false), "−37.8 %");
    EXPECT_EQ(text(.021, .001, true), "at most 2.1 %");
}

Rig relaxing_rig() {
    Rig rig = thesis_rig();
    rig.v = {1e-3};
    rig.t_rest = {60};
    rig.c.relaxation = {.branches = {{.3, .1}, {.2, 50}}};
    return rig;
}

// Each branch of the sum written out; J by the relaxation of two branches is not, but bounded: what
// is left of the creep is at most what is left of the stress (Zener's J(t) G(t) <= 1), and more
// than nothing.
TEST(RelaxedSubstrate, SumsItsBranches) {
    const Rig rig = relaxing_rig();
    const auto a = experiments::elastic_substrate(rig);
    ASSERT_EQ(a.criteria.size(), 3u);
    const double omega =
        2 * std::numbers::pi *
        experiments::calculate(rig, experiments::excitation_frequency).result.value;
    double loss = 0, stiffer = 0;
    for (const auto& [g, tau] : rig.c.relaxation->branches) {
        loss += g * omega * tau / (1 + std::pow(omega * tau, 2));
        stiffer += g * std::pow(omega * tau, 2) / (1 + std::pow(omega * tau, 2));
    }
    EXPECT_NEAR(a.criteria[0].calculation.result.value, loss, 1e-12);
    EXPECT_NEAR(a.criteria[1].calculation.result.value, stiffer, 1e-12);
}

// One branch that dominates: a standard solid's creep, J(t)/J_inf = 1 - g/(1 + g)
// exp(-t/((1 + g) tau)) (Christensen 1982, ch. 1); the other branch relaxes at once.
TEST(RelaxedSubstrate, CreepOfOneSlowBranchIsThatOfTheStandardSolid) {
    Rig rig = relaxing_rig();
    rig.c.relaxation = {.branches = {{1e-9, 1e-6}, {.5, 40}}};
    const auto a = experiments::elastic_substrate(rig);
    const double expected = .5 / 1.5 * std::exp(-60 / (1.5 * 40));
    EXPECT_NEAR(a.criteria[2].calculation.result.value, expected, 1e-8);
    EXPECT_EQ(a.standing(), experiments::Standing::violated);
    const auto effects = experiments::effects_on_measured(rig, {a});
    ASSERT_EQ(effects.size(), 1u);
    EXPECT_EQ(effects[0].measured, Measured::static_shift);
    EXPECT_NEAR(effects[0].relative.value, 1 / (1 - expected) - 1, 1e-8);
}

// A rest that nobody tells leaves that open, and is named.
TEST(RelaxedSubstrate, NamesWhatItLacks) {
    Rig rig = relaxing_rig();
    rig.t_rest = {};
    const auto a = experiments::elastic_substrate(rig);
    EXPECT_EQ(a.missing, std::vector<std::string>{"load.hold"});
    EXPECT_EQ(a.criteria.size(), 2u);
}

TEST(RelaxedSubstrate, HasBothSidesOfEachThreshold) {
    Rig rig = relaxing_rig();
    for (const auto& criterion : experiments::elastic_substrate(rig).criteria)
        EXPECT_FALSE(criterion.is_met_by(criterion.calculation.result.value))
            << criterion.calculation.name;
    rig.c.relaxation = {.branches = {{.01, 1e-3}, {.02, 1e-2}}};
    for (const auto& criterion : experiments::elastic_substrate(rig).criteria)
        EXPECT_TRUE(criterion.is_met_by(criterion.calculation.result.value))
            << criterion.calculation.name;
}

}  // namespace
}  // namespace tricontact::effects_test
