// Sentences of reports, and cases of which they must not be said.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "bem/settings.h"
#include "comparisons/half_space/deviation_output.h"
#include "comparisons/half_space/layer_report.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/figures.h"
#include "comparisons/run/loading_reading.h"
#include "comparisons/run/reading.h"
#include "comparisons/run/report_tables.h"
#include "comparisons/shakedown/limit.h"
#include "rolling/creep_theory.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::sentences_test {
namespace {

using contact::Case;

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += sentence + '\n';
    return text;
}

/// The report's findings of models that settle at the closed form.
std::string reading_of(const Case& c, const std::vector<std::string>& models,
                       contact::State state = contact::State::shakedown) {
    std::vector<Results> summaries;
    for (const std::string& model : models) {
        summaries.emplace_back(c, synthetic::settling_history(model));
        summaries.back().set(quantities::state, state);
    }
    return joined(reading(c, summaries));
}

/// nu = 0 under a rigid indenter: Dundurs' beta is 1/2.
Case coupled() {
    return synthetic::unit_case();
}
Case uncoupled() {
    Case c = synthetic::unit_case();
    c.contact.coupling = false;
    return c;
}
Case relaxing(double hold) {
    Case c = uncoupled();
    c.relaxation = contact::Relaxation{.branches = {{0.25, 10.}}};
    c.load.hold = hold;
    return c;
}

TEST(ReadingSentences, WhatAModelLeavesOut) {
    Case c = uncoupled();
    c.layer.thickness = 1;
    EXPECT_FALSE(says(reading_of(c, {"bem-layer", "fem"}), "leaves out"));
    c.layer.width = 8;
    const std::string text = reading_of(c, {"bem", "bem-layer", "fem"});
    EXPECT_TRUE(says(text, "BEM layer leaves out substrate.width: the layer is infinitely wide."))
        << text;
    EXPECT_FALSE(says(text, "FEM leaves out")) << text;
    EXPECT_FALSE(says(text, "BEM leaves out substrate.thickness"))
        << text;  // said in its own words
    EXPECT_TRUE(says(text, "the thickness of the layer is not seen")) << text;
}

TEST(ReadingSentences, WhoCouplesIsNotCalledUncoupled) {
    const std::string text = reading_of(coupled(), {"mdr", "bem"});
    EXPECT_TRUE(says(text, "MDR takes normal and tangential contact as uncoupled")) << text;
    EXPECT_TRUE(says(text, "BEM couples normal and tangential contact (Dundurs' β = 0.50)"));
    EXPECT_FALSE(says(text, "All models take normal"));
    const std::string apart = reading_of(uncoupled(), {"mdr", "bem"});
    EXPECT_TRUE(says(apart, "All models take normal and tangential contact as uncoupled"));
    EXPECT_FALSE(says(apart, "couples"));
    // beta = 0: bem leaves coupling out itself.
    Case rubber = coupled();
    rubber.substrate.poisson = 0.5;
    EXPECT_FALSE(says(reading_of(rubber, {"bem"}), "couples"));
    EXPECT_TRUE(says(reading_of(rubber, {"bem"}), "as uncoupled"));
}

// What a file of coefficients is of, a layer perhaps, the materials of the case do not tell.
TEST(ReadingSentences, NothingIsSaidOfTheBodiesOfAFileOfInfluenceCoefficients) {
    for (Case c : {coupled(), uncoupled()}) {
        c.of<bem::Settings>().influence = "layer.influence";
        const std::string text = reading_of(c, {"bem"});
        for (const char* claim : {"as uncoupled", "couples", "the bodies as", "is expected"})
            EXPECT_FALSE(says(text, claim)) << claim << ": " << text;
        EXPECT_FALSE(is_uncoupled_half_space(c, "bem"));
        EXPECT_TRUE(is_uncoupled_half_space(c, "mdr"));
    }
    Case rubber = coupled();
    rubber.substrate.poisson = 0.5;
    rubber.of<bem::Settings>().influence = "layer.influence";
    EXPECT_TRUE(couples(rubber, "bem")) << "it may";
}

TEST(ReadingSentences, TheExactLimitDecidesUncoupledElasticHalfSpacesOnly) {
    const std::string must = "By the exact limit it must", expected = "is expected";
    const auto undecided = [](const Case& c, const std::string& model) {
        return reading_of(c, {model}, contact::State::undecided);
    };
    EXPECT_TRUE(says(undecided(uncoupled(), "bem"), must));
    EXPECT_TRUE(says(undecided(uncoupled(), "bem"), expected));
    EXPECT_FALSE(says(undecided(coupled(), "bem"), must));
    EXPECT_FALSE(says(undecided(coupled(), "bem"), expected));
    EXPECT_TRUE(says(undecided(coupled(), "mdr"), must));
    EXPECT_TRUE(says(reading_of(coupled(), {"mdr", "bem"}), "shakedown is expected of MDR"));
    EXPECT_FALSE(says(undecided(relaxing(0), "bem"), must));
    for (const char* model : {"bem-layer", "fem", "mdr-layer"})
        EXPECT_FALSE(says(undecided(uncoupled(), model), expected)) << model;
}

TEST(ReadingSentences, WhatStillRelaxesIsNotComparedWithElasticBodies) {
    const std::string fresh = reading_of(relaxing(0), {"bem"});
    EXPECT_TRUE(says(fresh, "u_stat, 0 s after F_T has come, of a substrate that still relaxes"))
        << fresh;
    EXPECT_FALSE(says(fresh, "by Cattaneo and Mindlin; BEM")) << fresh;
    const std::string relaxed = reading_of(relaxing(70), {"bem"});
    EXPECT_TRUE(says(relaxed, "by Cattaneo and Mindlin; BEM")) << relaxed;
    EXPECT_FALSE(says(relaxed, "still relaxes"));
    EXPECT_FALSE(says(relaxed, "elastic half-spaces"));
    // The table leaves the closed form out likewise.
    const auto theory = [](const Case& c) {
        const auto tables = results_tables(c, {Results(c, synthetic::settling_history("bem"))});
        for (const auto& row : tables.front().rows)
            if (says(std::get<std::string>(row[0]), "u_stat")) return std::get<double>(row[3]);
        return 0.;
    };
    EXPECT_TRUE(std::isnan(theory(relaxing(0))));
    EXPECT_EQ(theory(relaxing(70)), theory(uncoupled()));
}

TEST(ReadingSentences, TheDipOfThePressureConcernsMdrWhereItRolls) {
    Case c = uncoupled();
    c.indenter.shape = Case::Shape::power_law;
    c.indenter.exponent = 6;
    const std::string ring = "largest in a ring", limit = "The shakedown limit of MDR";
    EXPECT_TRUE(says(reading_of(c, {"mdr", "bem"}), limit));
    EXPECT_TRUE(says(reading_of(c, {"bem"}), ring));
    EXPECT_FALSE(says(reading_of(c, {"bem"}), limit));
    c.rolling.reset();
    EXPECT_FALSE(says(reading_of(c, {"mdr"}), limit));
    EXPECT_FALSE(says(reading_of(uncoupled(), {"mdr"}), ring));
}

TEST(FigureSentences, NothingSlipsAnyMoreAfterShakedownOnly) {
    const auto caption = [](double f) {
        const synthetic::Options options{.f = f};
        return zone_figures(synthetic::unit_case(options), synthetic::two_models(options))
            .front()
            .caption;
    };
    EXPECT_TRUE(says(caption(0.56), "nothing slips any more"));
    EXPECT_FALSE(says(caption(0.9), "nothing slips any more"));  // ratchets
}

TEST(FigureSentences, StaticTheoryIsNamedAsThatOfItsBody) {
    const auto last_curve = [](const Case& c) {
        return shift_figures(c, synthetic::two_models()).back().curves.back().name;
    };
    EXPECT_EQ(last_curve(uncoupled()), "u_stat, Cattaneo and Mindlin");
    EXPECT_EQ(last_curve(relaxing(0)), "u_stat, Cattaneo and Mindlin, relaxed");
    Case cone = uncoupled();
    cone.indenter.shape = Case::Shape::cone;
    cone.indenter.angle = 0.1;
    EXPECT_EQ(last_curve(cone), "u_stat, superposed normal contacts");
    Case free = uncoupled();
    free.load.tangential_ratio = 0;
    EXPECT_FALSE(says(last_curve(free), "u_stat"));
}

TEST(TreatmentSentences, MdrOnTheLayerLeavesTheCouplingOut) {
    Case c = coupled();
    c.layer.thickness = 1;
    const std::string text = joined(treatment_sentences(c, {"mdr-layer"}, {}));
    EXPECT_TRUE(says(text, "MDR layer leaves out the coupling")) << text;
    EXPECT_FALSE(says(text, "such coupling")) << text;
}

TEST(TreatmentSentences, OnlyCoupledContactRemembersPressing) {
    const std::string remembers = "remembers the way of pressing";
    EXPECT_FALSE(says(joined(treatment_sentences(uncoupled(), {"bem"}, {})), remembers));
    EXPECT_TRUE(says(joined(treatment_sentences(coupled(), {"bem"}, {})), remembers));
}

TEST(LayerSentences, SidesAreAsFarAwayAsTheBaseWants) {
    Case c = uncoupled();
    c.layer.thickness = 4;
    const auto sides = [&] {
        return joined(
            layer_sentences(c, compare_with_layer(c, {synthetic::loaded_history("fem")}).value()));
    };
    EXPECT_TRUE(says(sides(), "(6 thicknesses to each side, or more)"));
    c.layer.base = Case::Base::frictionless;
    EXPECT_TRUE(says(sides(), "(40 thicknesses to each side, or more)"));
    EXPECT_FALSE(says(sides(), "(6 thicknesses"));
    c.layer.width = 4. * 2 * 10;  // ten to each side
    EXPECT_TRUE(says(sides(), "Less than 40 may be felt"));
    c.layer.base = Case::Base::bonded;
    EXPECT_FALSE(says(sides(), "may be felt"));
}

LimitStudy limit_study(bool is_coupled) {
    LimitStudy study;
    study.given = 0.24;
    ModelLimit& m = study.models.emplace_back();
    m.model = "bem";
    m.coupled = is_coupled;
    m.bracket.last_shakedown = 0.64;
    m.bracket.first_ratcheting = 0.6402;
    m.exact = 0.6401 * 1.00002;
    m.by_pressures = *m.exact;
    return study;
}

/// Verdicts and captions.
std::string words_of(const LimitStudy& study) {
    const report::Document document = limit_document(study);
    std::string text;
    for (const report::Verdict& verdict : document.verdicts) text += verdict.sentence + '\n';
    for (const auto& section : document.sections)
        for (const auto& figure : section.figures) text += figure.caption + '\n';
    return text;
}

TEST(LimitSentences, SquareRootsAreThoseOfRoundElasticUncoupledBodies) {
    const std::string root = "as a square root", patience = "to the power -1/2";
    EXPECT_TRUE(says(words_of(limit_study(false)), root));
    EXPECT_TRUE(says(words_of(limit_study(false)), patience));
    std::vector<LimitStudy> others(3, limit_study(false));
    others[0] = limit_study(true);
    others[1].round = false;
    others[2].relaxing = true;
    for (const LimitStudy& study : others) {
        EXPECT_FALSE(says(words_of(study), root));
        EXPECT_FALSE(says(words_of(study), patience));
    }
}

TEST(LimitSentences, SmallDifferencesKeepTheirDigits) {
    LimitStudy study = limit_study(true);
    study.models.front().bracket.last_shakedown = 0.64009999;
    study.models.front().bracket.first_ratcheting = 0.64010001;
    const std::string text = words_of(study);
    EXPECT_TRUE(says(text, "has its limit 0.00200 % below the uncoupled")) << text;
    EXPECT_FALSE(says(text, "0.00 %")) << text;
}

TEST(LimitSentences, TheThesisHasNoLimitOfRelaxingSubstrates) {
    EXPECT_TRUE(thesis_limit(uncoupled(), LimitVariable::load));
    EXPECT_FALSE(thesis_limit(relaxing(0), LimitVariable::load));
    Case oscillating = uncoupled();
    oscillating.load.normal_amplitude_ratio = 0.1;
    EXPECT_FALSE(thesis_limit(oscillating, LimitVariable::load));
}

TEST(TractiveSentences, TheRatioOfCreepagesIsThatOfRoundBodiesDrivenStraight) {
    Case c = uncoupled();
    c.rolling.reset();
    c.tractive_rolling.emplace();
    EXPECT_TRUE(rolling::has_thesis_creep_ratio(c));
    Case with_spin = c, cone = c, beta = c, slow = c;
    with_spin.tractive_rolling->spin = 1;
    cone.indenter.shape = Case::Shape::cone;
    beta.contact.coupling = true;
    slow.relaxation = contact::Relaxation{.branches = {{1, 1}}};
    for (const Case& other : {with_spin, cone, beta, slow})
        EXPECT_FALSE(rolling::has_thesis_creep_ratio(other));
}

}  // namespace
}  // namespace tricontact::comparisons::sentences_test
