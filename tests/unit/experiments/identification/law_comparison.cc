#include "experiments/identification/law_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "contact/model_makers.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/identification_study.h"
#include "tests/random/law_rig.h"

namespace tricontact::experiments::law_comparison_test {
namespace {

using Measurement = IdentificationInput::Measurement;

// A glass lens on silicone: friction in proportion to the area. Coulomb's law gave E = 2.08 MPa and
// mu = 2.86 for it.
constexpr double radius = 10e-3, young = 1.8e6, strength = .35e6;

IdentificationInput lens(const LawRig& rig, const std::vector<double>& loads, bool has_sliding,
                         double noise) {
    IdentificationInput input;
    IdentificationInput::Table shifts{.measurement = Measurement::static_shift},
        sliding{.measurement = Measurement::sliding_force};
    std::mt19937 random(46);
    std::normal_distribution<double> gauss;
    for (const double load : loads)
        for (int k = 1; k <= 9; ++k) {
            shifts.given.push_back(.1 * k * rig.limit(load));
            shifts.observed.push_back(rig.shift(load, shifts.given.back()));
            if (loads.size() > 1) shifts.normal_forces.push_back(load);
        }
    const double largest = *std::max_element(shifts.observed.begin(), shifts.observed.end());
    for (double& shift : shifts.observed) shift += noise * largest * gauss(random);
    input.tables.push_back(shifts);
    for (const double load : {.05, .1, .2, .4, .8, 1.2}) {
        sliding.given.push_back(load);
        sliding.observed.push_back(rig.limit(load) * (1 + noise * gauss(random)));
    }
    if (has_sliding) input.tables.push_back(sliding);
    input.models = {"half-space"};
    input.rig.indenter.radius = radius;
    input.rig.substrate = {1.2e6, .5};
    input.rig.friction.coefficient = 5;
    input.rig.load.normal_force = loads.back();
    return input;
}

LawComparison compared(IdentificationInput input, const std::vector<std::string>& laws) {
    input.parameters = free_parameters(input, {"substrate.young"});
    const contact::ModelMakers makers;
    return compare_laws(input, laws, {makers, 1});
}

const std::vector<std::string> laws_of_pressure{"coulomb", "shear-strength", "strength-and-coulomb",
                                                "power"};

const LawFit& fit_of(const LawComparison& laws, std::string_view name) {
    return *std::ranges::find(laws.laws, name, [](const LawFit& fit) { return fit.law->name; });
}

TEST(LawComparison, AStrengthIsNamedAndItsModulusFoundOnALens) {
    const LawRig rig(radius, young, [](double) { return strength; });
    const auto laws = compared(lens(rig, {.1, .3, 1}, true, .01), laws_of_pressure);
    ASSERT_TRUE(laws.named);
    const LawFit& named = laws.laws[*laws.named];
    EXPECT_EQ(named.law->name, "shear-strength");
    EXPECT_TRUE(fit_of(laws, "coulomb").is_excluded());
    const auto holds = [&](std::size_t k, double value) {
        const Interval interval = named.found.parameters[k].likelihood;
        return interval.low < value && value < interval.high &&
               interval.high - interval.low < .1 * value;
    };
    EXPECT_TRUE(holds(0, young));
    EXPECT_TRUE(holds(1, strength));
}

TEST(LawComparison, CoulombsLawIsNamedOnceMoreIsBounded) {
    const LawRig rig(radius, young, [](double p) { return .8 * p; });
    const auto laws = compared(lens(rig, {.1, .3, 1}, true, .01),
                               {"coulomb", "shear-strength", "power", "capped"});
    ASSERT_TRUE(laws.named);
    EXPECT_EQ(laws.laws[*laws.named].law->name, "coulomb");
    EXPECT_TRUE(fit_of(laws, "shear-strength").is_excluded());
    // Of two numbers the one that is not there costs what AICc says, and takes nothing away.
    EXPECT_LT(fit_of(laws, "power").wider.size(), 1U);
    EXPECT_LT(fit_of(laws, "coulomb").wider.front().likelihood_ratio, 4);
    EXPECT_NEAR(fit_of(laws, "power").found.parameters[2].value, 1, .1);
}

// Of three numbers, none at an end, measured within .05 %: all of fewer numbers are excluded.
TEST(LawComparisonSlow, ThreeNumbersAreFoundOfExactTables) {
    const LawRig rig(radius, young,
                     [](double p) { return 1e5 + .6 * 2e5 * std::pow(p / 2e5, 1.7); });
    const auto laws =
        compared(lens(rig, {.05, .3, 2}, true, 5e-4), {"coulomb", "power", "strength-and-power"});
    ASSERT_TRUE(laws.named);
    const LawFit& named = laws.laws[*laws.named];
    ASSERT_EQ(named.law->name, "strength-and-power");
    EXPECT_EQ(laws.supported().size(), 1U);
    const double p_r = *named.input.rig.friction.reference_pressure;
    for (const auto& [k, value] :
         std::map<int, double>{{0, young}, {1, 1e5}, {2, .6 * std::pow(p_r / 2e5, .7)}, {3, 1.7}}) {
        const Interval interval = named.found.parameters[k].likelihood;
        EXPECT_LT(interval.low, value) << k;
        EXPECT_GT(interval.high, value) << k;
        EXPECT_LT(interval.high - interval.low, .4 * value) << k;
    }
    // -2 ln L falls by what two more numbers take: chi^2 or F of two degrees of freedom.
    const LawFit& coulomb = fit_of(laws, "coulomb");
    EXPECT_EQ(named.n_fitted, coulomb.n_fitted + 2);
    EXPECT_EQ(fit_of(laws, "power").n_fitted, coulomb.n_fitted + 1);
}

// Of 1 % of noise a strength is named, though mu may be anything where n = 0, and n where mu = 0;
// Coulomb's law is not: there is room for a strength and n above 1.
TEST(LawComparisonSlow, ThreeNumbersLeaveRoomBesideCoulombsLaw) {
    const LawRig strong(radius, young, [](double) { return strength; });
    const auto named =
        compared(lens(strong, {.1, .3, 1}, true, .01), {"shear-strength", "strength-and-power"});
    ASSERT_TRUE(named.named);
    EXPECT_EQ(named.laws[*named.named].law->name, "shear-strength");
    const Interval n = fit_of(named, "strength-and-power").found.parameters[3].likelihood;
    EXPECT_GT(n.high - n.low, 1);
    const LawRig weak(radius, young, [](double p) { return .8 * p; });
    const auto open =
        compared(lens(weak, {.1, .3, 1}, true, .02), {"coulomb", "strength-and-power"});
    EXPECT_FALSE(open.named);
    EXPECT_FALSE(fit_of(open, "coulomb").is_excluded());
    EXPECT_NE(fit_of(open, "coulomb").not_told_from.find("n from"), std::string::npos);
}

// A law that is stated is found as the one that is compared.
TEST(LawComparison, AStatedLawHasTheNumbersOfTheComparedOne) {
    const LawRig rig(radius, young, [](double) { return strength; });
    IdentificationInput input = lens(rig, {.1, .3, 1}, true, .01);
    const LawFit fit = compared(input, {"shear-strength"}).laws.front();
    input.rig.friction = {.shear_strength = 1e5};
    input.parameters = free_parameters(input, {"substrate.young", "friction.shear_strength"});
    const contact::ModelMakers makers;
    const auto study = identification_study(input, false, {makers, 1}, [](const auto&) {});
    for (int k = 0; k < 2; ++k)
        EXPECT_NEAR(study.models.front().found.parameters[k].value, fit.found.parameters[k].value,
                    1e-9 * fit.found.parameters[k].value);
    EXPECT_FALSE(study.laws);
}

// From shifts of few forces under one load, far from sliding, nothing is told.
TEST(LawComparison, FewShiftsUnderOneLoadTellNoLaw) {
    const LawRig rig(radius, young, [](double) { return strength; });
    IdentificationInput input = lens(rig, {.5}, false, .01);
    for (auto* column : {&input.tables[0].given, &input.tables[0].observed}) column->resize(5);
    const auto laws = compared(input, {"coulomb", "shear-strength"});
    EXPECT_FALSE(laws.named);
    EXPECT_EQ(laws.supported().size(), 2U);
}

// A law that is none of those compared is not replaced by one of them: stated errors say so.
TEST(LawComparison, NoneIsNamedWhereNoneExplains) {
    const LawRig rig(radius, young, [](double p) { return .5 * p + 4e5 * std::pow(p / 4e5, 2); });
    IdentificationInput input = lens(rig, {.1, .3, 1}, true, .005);
    for (auto& table : input.tables) {
        const double largest = *std::max_element(table.observed.begin(), table.observed.end());
        table.standard_errors.assign(table.observed.size(), .005 * largest);
    }
    const auto laws = compared(input, {"coulomb", "shear-strength"});
    EXPECT_FALSE(laws.named);
    EXPECT_TRUE(laws.supported().empty());
}

// Asked for E and mu alone, as before: Coulomb's values are not handed out without a word.
TEST(LawComparison, CoulombsLawAloneIsHeldAgainstAStrength) {
    const contact::ModelMakers makers;
    const auto sentence_of = [&](const LawRig& rig, double noise) {
        IdentificationInput input = lens(rig, {.5}, false, noise);
        input.rig.friction.coefficient = 1;
        input.parameters = free_parameters(input, {"substrate.young", "friction.coefficient"});
        const auto study = identification_study(input, false, {makers, 1}, [](const auto&) {});
        return law_verdicts(study).front();
    };
    const auto strong = sentence_of(LawRig(radius, young, [](double) { return strength; }), .003);
    EXPECT_EQ(strong.standing, report::Verdict::Standing::violated);
    EXPECT_NE(strong.sentence.find("E and mu are not to be used"), std::string::npos);
    const auto weak = sentence_of(LawRig(radius, young, [](double p) { return .8 * p; }), .003);
    EXPECT_EQ(weak.standing, report::Verdict::Standing::holds);
}

}  // namespace
}  // namespace tricontact::experiments::law_comparison_test
