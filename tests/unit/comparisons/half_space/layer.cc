#include "comparisons/half_space/layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bem/settings.h"
#include "comparisons/half_space/layer_report.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/report.h"
#include "tests/unit/comparisons/document.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::layer_test {
namespace {

using contact::Case;

/// The thesis' rig 5.1.1: rubber of 8 mm, rigid sphere.
Case rig() {
    Case c;
    c.models = {"mdr", "fem"};
    c.indenter.radius = 0.04;
    c.substrate = {5.2e6, 0.5};
    c.layer.thickness = 8e-3;
    c.friction.coefficient = 0.57;
    c.load.normal_force = 21.1;
    c.load.tangential_ratio = 0.56;
    return c;
}

/// A history whose scales are these values.
contact::History history_of(const std::string& model, const PressedValues& v) {
    contact::History history = synthetic::loaded_history(model);
    history.scales = {.normal_force = v.normal_force,
                      .contact_radius = v.contact_radius,
                      .indentation = v.indentation,
                      .peak_pressure = v.peak_pressure,
                      .unit_shift = v.unit_shift.value()};
    return history;
}

/// MDR as Hertz, FEM as the exact layer with 1 % more indentation.
std::vector<contact::History> histories_of(const Case& c) {
    PressedValues exact = compare_with_layer(c, {}).value().exact.value();
    exact.indentation *= 1.01;
    return {history_of("mdr", hertz_values(c)), history_of("fem", exact)};
}

LoadingStudy study() {
    LoadingStudy result;
    result.normal_stiffness["fem"] = 1.25e5;
    return result;
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

TEST(Layer, RigAgainstIndependentNumbers) {
    const LayerComparison layer = compare_with_layer(rig(), {}).value();
    const PressedValues& e = layer.exact.value();
    // Spectral solution of another program, four digits given: half a unit of the last.
    EXPECT_NEAR(e.contact_radius, 4.3638e-3, 0.5e-7);
    EXPECT_NEAR(e.indentation, 0.3229e-3, 0.5e-7);
    EXPECT_NEAR(e.peak_pressure, 0.5330e6, 0.5e2);
    EXPECT_NEAR(*e.unit_shift / 0.57, 0.6651e-3, 0.5e-7);
    EXPECT_NEAR(layer.half_space.contact_radius, 4.5028e-3, 1e-7);
    EXPECT_NEAR(layer.half_space.indentation, 0.5069e-3, 0.5e-7);
    EXPECT_NEAR(layer.half_space.peak_pressure, 0.4969e6, 0.5e2);
    EXPECT_NEAR(*layer.half_space.unit_shift / 0.57, 0.7603e-3, 0.5e-7);
    EXPECT_NEAR(layer.thickness_ratio, 0.889, 1e-3);
    // Three digits: 1.99 times the half-space's stiffness.
    EXPECT_NEAR(*e.normal_stiffness / *layer.half_space.normal_stiffness, 1.99, 0.005);
    EXPECT_FALSE(layer.half_width);
}

TEST(Layer, ThickLayersAreHalfSpaces) {
    Case c = rig();
    c.layer.thickness = 1000 * 4.5e-3;
    const LayerComparison layer = compare_with_layer(c, {}).value();
    for (const PressedQuantity& q : pressed_quantities()) {
        // The indentation at equal force lacks 1.127 a/b = 1.1e-3, the stiffness as much, the
        // others less (series of Garcia and Garcia 2018).
        EXPECT_NEAR(*q.get(*layer.exact) / *q.get(layer.half_space), 1, 2e-3) << q.quantity->key;
    }
    EXPECT_NEAR(layer.apparent->from_indentation, 5.2e6, 2e-3 * 5.2e6);
    EXPECT_NEAR(layer.apparent->from_contact_radius, 5.2e6, 2e-3 * 5.2e6);
    EXPECT_NEAR(*layer.apparent->from_unit_shift, 5.2e6, 2e-3 * 5.2e6);
}

TEST(Layer, ApparentModuliReproduceTheLayersValuesByHertz) {
    Case c = rig();
    const LayerComparison layer = compare_with_layer(c, {}).value();
    const auto hertz_with = [&](double young) {
        Case other = c;
        other.substrate.young = young;
        return hertz_values(other);
    };
    // Both directions are closed forms.
    EXPECT_NEAR(hertz_with(layer.apparent->from_indentation).indentation / layer.exact->indentation,
                1, 1e-12);
    EXPECT_NEAR(hertz_with(layer.apparent->from_contact_radius).contact_radius /
                    layer.exact->contact_radius,
                1, 1e-12);
    EXPECT_NEAR(*hertz_with(*layer.apparent->from_unit_shift).unit_shift / *layer.exact->unit_shift,
                1, 1e-12);
}

TEST(Layer, IndentationMayBePrescribed) {
    Case c = rig();
    const double force = *c.load.normal_force;
    c.load.indentation = compare_with_layer(c, {}).value().exact->indentation;
    c.load.normal_force.reset();
    const LayerComparison layer = compare_with_layer(c, {}).value();
    EXPECT_NEAR(layer.exact->normal_force, force, 1e-8 * force);  // theory is good to 1e-10
    expect_parts(joined(layer_sentences(c, layer)), {"at equal indentation, makes the force"});
}

TEST(Layer, WhereTheoryIsSilentItSaysWhy) {
    Case two = rig();
    two.layer.lower = {{2e-3, {1e7, 0.4}}};
    Case elastic = rig();
    elastic.indenter.material = contact::Material{5.2e6, 0.5};
    Case thin = rig();
    thin.layer.thickness = 1e-5;  // a/b = 45 or so
    Case ground = rig();
    ground.layer.base = Case::Base::half_space;
    ground.layer.ground = contact::Material{70e9, .3};
    Case periodic = rig();
    periodic.period = 80e-3;
    Case others = rig();
    others.of<bem::Settings>().influence = "influence.txt";
    for (const auto& [c, why] :
         {std::pair(two, "one layer"), std::pair(elastic, "rigid"),
          std::pair(thin, "exceeds 32 thicknesses"), std::pair(ground, "rigid ground"),
          std::pair(periodic, "one in each period"), std::pair(others, "come from a file")}) {
        const LayerComparison layer = compare_with_layer(c, {}).value();
        EXPECT_FALSE(layer.exact) << why;
        EXPECT_FALSE(layer.apparent) << why;
        EXPECT_NE(layer.why_not.find(why), std::string::npos) << layer.why_not;
        expect_parts(joined(layer_sentences(c, layer)), {why});
        EXPECT_TRUE(layer_json(c, layer)["exact"].is_null());
        EXPECT_FALSE(layer_json(c, layer)["why_no_exact"].is_null());
    }
    two.layer.lower.push_back({1e-3, {1e6, 0.2}});
    expect_parts(joined(layer_sentences(two, compare_with_layer(two, {}).value())),
                 {"rests on 2 further layers of 3 mm together"});
    expect_parts(joined(layer_sentences(ground, compare_with_layer(ground, {}).value())),
                 {"bonded to a half-space of E = 70 GPa"});
    Case steel = rig();
    steel.indenter.material = contact::Material{206e9, 0.3};
    EXPECT_TRUE(compare_with_layer(steel, {}).value().exact);
}

TEST(Layer, FrictionlessBaseHasNoUnitShift) {
    Case c = rig();
    c.layer.base = Case::Base::frictionless;
    const LayerComparison layer = compare_with_layer(c, {}).value();
    ASSERT_TRUE(layer.exact);
    EXPECT_FALSE(layer.exact->unit_shift);
    EXPECT_FALSE(layer.apparent->from_unit_shift);
    expect_parts(joined(layer_sentences(c, layer)), {"glides on its rigid ground"});
}

TEST(Layer, CasesWithoutThicknessHaveNoLayer) {
    Case c = rig();
    c.layer.thickness.reset();
    EXPECT_FALSE(compare_with_layer(c, {}));
}

TEST(Layer, ModelsStandBesideTheExactLayer) {
    const Case c = rig();
    const LayerComparison layer = compare_with_layer(c, histories_of(c), study()).value();
    ASSERT_EQ(layer.models.size(), 2u);
    EXPECT_EQ(layer.models[1].values.normal_stiffness, 1.25e5);
    // 2 E* a of Hertz' own radius.
    EXPECT_NEAR(*layer.models[0].values.normal_stiffness, *layer.half_space.normal_stiffness, 1e-6);

    const report::DocumentTable table = layer_table(c, layer);
    EXPECT_EQ(headings(table),
              (std::vector<std::string>{"quantity", "unit", "exact layer", "half-space", "MDR",
                                        "FEM", "half-space vs exact [%]", "MDR vs exact [%]",
                                        "FEM vs exact [%]"}));
    const auto& d = table.rows[1];
    const double due[] = {322.9, 506.9, 506.9, 326.1, 57, 57, 1};
    for (std::size_t i = 0; i < std::size(due); ++i)
        EXPECT_NEAR(std::get<double>(d[i + 2]), due[i], 0.05) << i;
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(Layer, TableWithoutTheoryHasNoDifferences) {
    Case c = rig();
    const auto histories = histories_of(c);
    c.layer.lower = {{2e-3, {1e7, 0.4}}};
    const report::DocumentTable table = layer_table(c, compare_with_layer(c, histories).value());
    EXPECT_EQ(headings(table),
              (std::vector<std::string>{"quantity", "unit", "half-space", "MDR", "FEM"}));
    EXPECT_TRUE(std::isnan(std::get<double>(table.rows.back().back())));  // nobody measured it
}

TEST(LayerSentences, SayWhatIgnoringTheThicknessDoes) {
    const Case c = rig();
    const LayerComparison layer = compare_with_layer(c, histories_of(c)).value();
    expect_parts(
        joined(layer_sentences(c, layer)),
        {"The layer is 8 mm thick, 0.888 times the diameter of Hertz' contact, and bonded",
         "MDR is a half-space model and ignores the thickness. That alone, at equal force, "
         "makes the indentation 57.0 % larger, the contact radius 3.19 % larger, the peak "
         "pressure 6.78 % smaller and U_max 14.3 % larger",
         // 5.2 (0.5069/0.3229)^1.5 and so on
         "E = 10.2 MPa from force and indentation, 5.71 MPa from the contact radius and "
         "6.36 MPa from U_max; the layer has 5.2 MPa",
         "so wide that its sides are hardly felt"});
}

TEST(LayerSentences, FiniteBlocksAreMeasuredInThicknesses) {
    Case c = rig();
    c.layer.width = 0.06;
    const LayerComparison layer = compare_with_layer(c, histories_of(c)).value();
    EXPECT_NEAR(layer.half_width.value(), 3.75, 1e-12);
    expect_parts(joined(layer_sentences(c, layer)),
                 {"width of 60 mm puts the sides 3.75 thicknesses from the centre",
                  "its depth is unbounded", "Less than 6 may be felt"});
    c.layer.width = 0.2;
    c.layer.lower = {{2e-3, {1e7, 0.4}}};
    const LayerComparison wide = compare_with_layer(c, histories_of(rig())).value();
    EXPECT_NEAR(wide.half_width.value(), 10, 1e-12);  // of both layers
    EXPECT_EQ(joined(layer_sentences(c, wide)).find("may be felt"), std::string::npos);
}

TEST(LayerJson, CarriesTheSameNumbers) {
    Case c = rig();
    c.layer.width = 0.06;
    const LayerComparison layer = compare_with_layer(c, histories_of(c), study()).value();
    const auto json = nlohmann::ordered_json::parse(
        summary_json("1", nullptr, {}, {{"layer", layer_json(c, layer)}}))["layer"];
    EXPECT_EQ(json["thickness_m"], 8e-3);
    EXPECT_NEAR(json["half_width_over_thickness"].get<double>(), 3.75, 1e-12);
    EXPECT_TRUE(json["half_depth_over_thickness"].is_null());
    EXPECT_EQ(json["exact"]["indentation_m"].get<double>(), layer.exact->indentation);
    EXPECT_NEAR(json["half_space_over_exact"]["indentation"].get<double>(), 0.5698, 1e-4);
    EXPECT_EQ(json["apparent_young_Pa"]["from_indentation"].get<double>(),
              layer.apparent->from_indentation);
    EXPECT_EQ(json["models"]["mdr"]["ignores_thickness"], true);
    EXPECT_NEAR(json["models"]["fem"]["over_exact"]["indentation"].get<double>(), 0.01, 1e-12);
    EXPECT_EQ(json["contact"]["coupling"], true);
    EXPECT_EQ(json["contact"]["press_steps"], 20);
}

TEST(LayerJson, IsNotThereWithoutALayer) {
    EXPECT_FALSE(nlohmann::json::parse(summary_json("1", nullptr, {})).contains("layer"));
}

TEST(LayerReport, HasItsSectionsAndTables) {
    const Case c = rig();
    ReportExtras extras{study(), Refinement{}, {}};
    extras.refinement->key = "fem.size";
    extras.refinement->sizes = {1e-3, 7e-4, 5e-4};
    const auto theory_column = [](const report::Document& document) {
        return find_section(document, "results")->tables.front().columns[4].heading;
    };
    const report::Document with = run_document(c, "case", "1", histories_of(c), extras);
    EXPECT_EQ(find_section(with, "layer")->tables.front().id, "layer");
    EXPECT_EQ(find_section(with, "refinement")->tables.front().id, "refinement");
    EXPECT_TRUE(std::ranges::count(
        with.settings, std::pair<std::string, std::string>{"layer thickness b", "8 mm"}));
    EXPECT_EQ(theory_column(with), "half-space theory");
    Case without_layer = c;
    without_layer.layer.thickness.reset();
    const report::Document without = run_document(without_layer, "case", "1", histories_of(c));
    for (const char* id : {"layer", "refinement"}) EXPECT_FALSE(find_section(without, id)) << id;
    EXPECT_EQ(theory_column(without), "theory");
}

}  // namespace
}  // namespace tricontact::comparisons::layer_test
