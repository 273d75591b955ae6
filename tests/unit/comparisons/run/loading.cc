#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparisons/quantities/results.h"
#include "comparisons/run/loading_reading.h"
#include "comparisons/run/report.h"
#include "tests/unit/comparisons/document.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::loading_test {
namespace {

using contact::Case;
using contact::State;

/// The thesis' rig 5.1.1: rubber of 8 mm, rigid sphere.
Case rig() {
    Case c;
    c.models = {"mdr", "mdr-layer", "bem-layer", "fem"};
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    return c;
}

RunValues settled(double static_shift, double shift) {
    return {static_shift, State::shakedown, shift, 0};
}
RunValues ratcheting(double static_shift, double increment) {
    return {static_shift, State::ratcheting, 20 * increment, increment};
}

std::vector<LoadingVariant> variants() {
    const RunValues run = settled(1.5e-4, 2e-4);
    return {
        {{"bem-layer", run, settled(1.485e-4, 1.9e-4), ""}, "contact.coupling", "true", "false"},
        {{"bem-layer", run, {}, "no end"}, "load.press", "friction", "frictionless"},
        {{"fem", {1.5e-4}, RunValues{1.53e-4}, ""}, "load.press", "friction", "frictionless"},
        {{"fem", run, ratcheting(1.56e-4, 1e-4), ""}, "load.press_steps", "20", "1"}};
}

std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += sentence + "\n";
    return text;
}

void expect_parts(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nin: " << text;
}

TEST(LoadingVariant, ComparesWhatTheVerdictsHaveInCommon) {
    LoadingVariant v;
    v.run = settled(1e-4, 2e-4);
    EXPECT_FALSE(v.static_error());
    EXPECT_FALSE(v.rolled_error());
    v.other = settled(1.1e-4, 1.9e-4);
    EXPECT_NEAR(v.static_error().value(), .1, 1e-15);
    EXPECT_NEAR(v.rolled_error().value(), -.05, 1e-15);
    v.other = ratcheting(1.1e-4, 3e-5);
    EXPECT_FALSE(v.rolled_error());
    v.run = ratcheting(1e-4, 2e-5);
    EXPECT_NEAR(v.rolled_error().value(), .5, 1e-15);
    v.run = settled(0, 0);  // no tangential force
    EXPECT_FALSE(v.static_error());
    v.run = v.other.value() = RunValues{1e-4};
    EXPECT_FALSE(v.rolled_error());
}

TEST(TreatmentSentences, CarryTheNumbersOfTheStudy) {
    const Case c = rig();
    expect_parts(
        joined(treatment_sentences(c, c.models, variants())),
        {"BEM layer and FEM couple normal and tangential contact (contact.coupling = true)",
         "With contact.coupling = false the static shift of BEM layer would be 148.5 µm instead of "
         "150.0 µm (−1.0 %), and the shift after rolling 190.0 µm instead of 200.0 µm (−5.0 %).",
         "MDR has no coupling", "MDR layer leaves out the coupling",
         "in 20 equal steps with friction",
         "With load.press = frictionless there is no number: no end.",
         "of FEM would be 156.0 µm instead of 150.0 µm (+4.0 %), and the verdict ratcheting "
         "instead "
         "of shakedown."});
}

// A contact that is pressed alone has no tangential load to come then.
TEST(TreatmentSentences, ThenTheTangentialOneWhereThereIsOne) {
    Case c = rig();
    EXPECT_NE(joined(treatment_sentences(c, c.models, variants())).find("then the tangential one"),
              std::string::npos);
    c.rolling.reset();
    c.load.set_tangential_ratio(0);
    EXPECT_EQ(joined(treatment_sentences(c, c.models, variants())).find("tangential one"),
              std::string::npos);
}

// A run that stops as variants are rolled says by what; nothing is claimed of rolling.
TEST(TreatmentSentences, SayWhyNothingWasRolled) {
    const Case c = rig();
    LoadingVariant loaded{
        {"bem-layer", {1.5e-4}, RunValues{1.53e-4}, ""}, "contact.coupling", "true", "false"};
    loaded.why_not_rolled = "no minimum within 500 steps";
    const std::string text = joined(treatment_sentences(c, c.models, {loaded}));
    expect_parts(text, {"(+2.0 %), after rolling it is unknown (no minimum within 500 steps)."});
    EXPECT_EQ(loading_json({loaded})[0]["why_not_rolled"], "no minimum within 500 steps");
}

TEST(TreatmentSentences, WithoutAStudyNoNumberIsClaimed) {
    const Case c = rig();
    const std::string text = joined(treatment_sentences(c, c.models, {}));
    EXPECT_EQ(text.find("would be"), std::string::npos) << text;
    expect_parts(text, {"20 equal steps"});
}

TEST(TreatmentSentences, WithoutRollingTheStaticShiftIsCompared) {
    const Case c = rig();
    const LoadingVariant loaded{
        {"bem-layer", {1.5e-4}, RunValues{1.53e-4}, ""}, "contact.coupling", "true", "false"};
    expect_parts(joined(treatment_sentences(c, c.models, {loaded})),
                 {"With contact.coupling = false the static shift of BEM layer would be 153.0 µm "
                  "instead of 150.0 µm (+2.0 %)."});
}

// A contact pressed alone has no shift but for rounding: what is not prescribed is compared.
TEST(TreatmentSentences, PressedAloneTheForceOrTheIndentationIsCompared) {
    Case c = rig();
    c.load.tangential_ratio = 0;
    LoadingVariant pressed{
        {"bem-layer", {-6e-19}, RunValues{0}, ""}, "contact.coupling", "true", "false"};
    pressed.run.indentation = 4.678e-4, pressed.other->indentation = 4.729e-4;
    pressed.run.normal_force = pressed.other->normal_force = 3;
    pressed.loaded = &not_prescribed(c);
    expect_parts(joined(treatment_sentences(c, c.models, {pressed})),
                 {"the indentation at the end of BEM layer would be 472.9 µm instead of 467.8 µm "
                  "(+1.1 %)."});
    EXPECT_NEAR(pressed.loaded_error().value(), 4.729 / 4.678 - 1, 1e-12);
    EXPECT_EQ(loading_json({pressed})[0]["loaded_quantity"], "end_indentation_m");
    EXPECT_EQ(std::get<std::string>(variants_table({pressed}).rows.at(0)[2]), "µm");
    c.load.indentation = 4.678e-4;
    pressed.loaded = &not_prescribed(c);
    pressed.other->normal_force = 2.9;
    expect_parts(joined(treatment_sentences(c, c.models, {pressed})),
                 {"the normal force at the end of BEM layer would be 2.900 N instead of 3.000 N"});
}

TEST(TreatmentSentences, CouplingThatIsLeftOutIsSaid) {
    Case c = rig();
    c.substrate.poisson = 0.3;  // Dundurs' beta 0.29 under a rigid indenter
    c.contact.coupling = false;
    expect_parts(joined(treatment_sentences(c, {"mdr", "fem"}, {})),
                 {"left out of FEM (contact.coupling = false)",
                  "MDR leaves out the coupling that these materials have on a half-space: Dundurs' "
                  "|β| exceeds 0.001 (β = 0.29)"});
    expect_parts(joined(treatment_sentences(c, {"mdr", "bem"}, {})), {"MDR and BEM leave out"});
    c.contact.coupling = true;
    expect_parts(joined(treatment_sentences(c, {"bem"}, {})), {"BEM couples normal"});
}

TEST(VariantsTable, HasARowForLoadingAndOneForRolling) {
    const report::DocumentTable table = variants_table(variants());
    std::vector<std::vector<report::Cell>> settled;
    std::size_t n_static = 0;
    for (const auto& row : table.rows) {
        EXPECT_EQ(row.size(), table.columns.size());
        const auto& name = std::get<std::string>(row[0]);
        if (name == "BEM layer: static shift") ++n_static;
        if (name == "BEM layer: settled shift") settled.push_back(row);
    }
    EXPECT_EQ(n_static, 2u);
    ASSERT_GE(settled.size(), 2u);
    EXPECT_NEAR(std::get<double>(settled[0][3]), 200, 1e-9);
    EXPECT_NEAR(std::get<double>(settled[0][4]), 190, 1e-9);
    EXPECT_NEAR(std::get<double>(settled[0][5]), -5, 1e-9);
    for (const int column : {4, 5}) EXPECT_TRUE(std::isnan(std::get<double>(settled[1][column])));
    EXPECT_EQ(std::get<std::string>(table.rows.back()[4]), "ratcheting");
    EXPECT_TRUE(std::isnan(std::get<double>(table.rows.back()[5])));
}

TEST(LoadingJson, CarriesTheSameNumbers) {
    const auto json = nlohmann::ordered_json::parse(summary_json(
        "1", nullptr, {}, {{"loading_variants", loading_json(variants())}}))["loading_variants"];
    ASSERT_EQ(json.size(), 4u);
    EXPECT_NEAR(json[0]["rolled_change"].get<double>(), -0.05, 1e-12);
    EXPECT_EQ(json[0]["other"]["final_shift_m"], 1.9e-4);
    EXPECT_TRUE(json[1]["other"].is_null());
    EXPECT_EQ(json[1]["why_none"], "no end");
    EXPECT_EQ(json[2]["loaded_quantity"], "static_shift_m");
    EXPECT_NEAR(json[2]["loaded_change"].get<double>(), 0.02, 1e-12);
    EXPECT_TRUE(json[2]["run"]["final_shift_m"].is_null());
    EXPECT_EQ(json[3]["other"]["state"], "ratcheting");
    EXPECT_EQ(json[3]["other"]["shift_increment_m"], 1e-4);
    EXPECT_TRUE(json[3]["rolled_change"].is_null());
    EXPECT_FALSE(nlohmann::json::parse(
                     summary_json("1", nullptr, {}, {{"loading_variants", loading_json({})}}))
                     .contains("loading_variants"));
}

TEST(LoadingReport, HasItsSectionWithALayerOrVariants) {
    Case c = rig();
    const std::vector<contact::History> histories{synthetic::loaded_history("mdr")};
    const auto section = [&](const LoadingStudy& study) {
        const auto document = run_document(c, "case", "1", histories, {study, {}, {}});
        const report::DocumentSection* found = find_section(document, "loading");
        return found ? std::optional(*found) : std::nullopt;
    };
    EXPECT_TRUE(section({}));
    c.layer.thickness.reset();
    EXPECT_FALSE(section({}));
    const auto found = section({variants(), {}});
    ASSERT_TRUE(found);
    expect_parts(joined(found->paragraphs), {"148.5 µm instead of"});
    const auto& rows = found->tables.front().rows;
    EXPECT_TRUE(std::ranges::any_of(rows, [](const auto& row) {
        return std::get<std::string>(row[1]) == "contact.coupling: false instead of true";
    }));
}

}  // namespace
}  // namespace tricontact::comparisons::loading_test
