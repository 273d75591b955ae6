// The table of models: complete, and what its rows say is what the models do.

#include "contact/models/model_kind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bem/model.h"
#include "bem/settings.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/reference.h"
#include "contact/load_path.h"
#include "contact/model.h"
#include "io/case/case_keys.h"
#include "io/case/case_reader.h"
#include "io/case/measurement_models.h"
#include "io/case/rig_keys.h"
#include "mdr/layer_model.h"
#include "mdr/model.h"
#include "report/format.h"
#include "report/plot_style.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::model_kind_test {
namespace {

using contact::Case;
using contact::Model;
using contact::model_kind;
using contact::model_kinds;
using contact::ModelKind;

/// A sphere of 40 mm on a layer; its contact radius on the half-space is 5 mm.
Case layer_case(double thickness, double poisson = .5) {
    Case c = io::parse_case(io::loaded_sphere, "case.toml",
                            {"substrate.thickness=\"8 mm\"", "bem.cells_per_radius=12"});
    c.layer.thickness = thickness;
    c.substrate.poisson = poisson;
    return c;
}

/// The models of the libraries that these tests link, as app/models/make_model.cc makes them.
std::unique_ptr<Model> made(const std::string& name, const Case& c) {
    if (name == contact::models::mdr) return mdr::make_model(c);
    if (name == contact::models::mdr_layer) return mdr::make_layer_model(c);
    if (name == contact::models::bem) return bem::make_model(c, 1);
    return bem::make_model(c, 1, bem::Body::layer);
}

std::vector<ModelKind> linked() {
    std::vector<ModelKind> all;
    for (const ModelKind& kind : model_kinds())
        if (!kind.is_meshed() && !kind.is_read()) all.push_back(kind);
    return all;
}

double contact_radius(const ModelKind& kind, const Case& c) {
    const auto model = made(kind.name, c);
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model->advance(step);
    return model->scales().contact_radius;
}

std::vector<std::string> words(const io::Key& key) {
    std::vector<std::string> all;
    for (const auto& choice : key.choices) all.emplace_back(choice.word);
    return all;
}

TEST(ModelKinds, AreThoseThatCasesName) {
    const auto* key = io::find_key("models");
    ASSERT_NE(key, nullptr);
    const auto named = words(*key);
    ASSERT_EQ(named.size(), model_kinds().size());
    for (std::size_t i = 0; i < named.size(); ++i) EXPECT_EQ(named[i], model_kinds()[i].name);
    for (const std::string& name : named) EXPECT_NE(contact::find_model_kind(name), nullptr);
}

TEST(ModelKinds, NameKeysAndModelsThatThereAre) {
    for (const ModelKind& kind : model_kinds()) {
        SCOPED_TRACE(kind.name);
        const std::string section = kind.section, resolution = kind.resolution;
        EXPECT_EQ(resolution.empty(), *kind.why_no_levels != 0);
        if (!resolution.empty()) {
            EXPECT_NE(io::find_key(resolution), nullptr);
            EXPECT_TRUE(resolution.starts_with(section + '.'));
            EXPECT_TRUE(contact::is_model_section(section));
        }
        if (*kind.maps) {
            EXPECT_TRUE(model_kind(kind.maps).has_maps());
        }
        EXPECT_NE(*kind.title, 0);
        EXPECT_NE(*kind.text, 0);
        EXPECT_NE(*kind.sources, 0);
    }
    EXPECT_FALSE(contact::is_model_section(""));
    EXPECT_FALSE(contact::is_model_section("load"));
}

TEST(ModelKinds, HaveColoursOfTheirOwn) {
    std::set<int> styles;
    for (const ModelKind& kind : model_kinds()) {
        EXPECT_EQ(report::display_name(kind.name), kind.title);
        EXPECT_EQ(report::model_style(kind.name), kind.style);
        EXPECT_EQ(report::model_style(kind.title), kind.style);
        if (!kind.style) continue;
        EXPECT_LT(*kind.style, report::n_model_colours);
        EXPECT_TRUE(styles.insert(*kind.style).second) << kind.name;
    }
    EXPECT_EQ(report::model_style("Hertz"), std::nullopt);
}

TEST(ModelKinds, AreWhatModelsCallThemselves) {
    for (const ModelKind& kind : linked())
        EXPECT_EQ(made(kind.name, layer_case(8e-3))->name(), kind.name);
}

// Half-spaces of nu = 1/2 under a rigid sphere are uncoupled, those of less are not (Dundurs);
// springs on a line have no other direction to couple with.
TEST(ModelKinds, CoupleAsTheModelsDo) {
    for (const ModelKind& kind : linked())
        for (const double poisson : {.3, .5})
            for (const bool coupling : {false, true}) {
                Case c = layer_case(8e-3, poisson);
                c.contact.coupling = coupling;
                EXPECT_EQ(made(kind.name, c)->is_coupled(), comparisons::couples(c, kind.name))
                    << kind.name << ", nu = " << poisson << ", coupling " << coupling;
            }
}

// A half-space does not see where its layer ends; a bonded layer of half the contact radius is
// stiffer: the contact of nu = 1/2 is smaller by more than a tenth.
TEST(ModelKinds, OfLayersSeeTheThickness) {
    for (const ModelKind& kind : linked()) {
        const double thick = contact_radius(kind, layer_case(50e-3));
        const double thin = contact_radius(kind, layer_case(2.5e-3));
        if (kind.is_half_space())
            EXPECT_EQ(thin, thick) << kind.name;
        else
            EXPECT_LT(thin, .9 * thick) << kind.name;
        EXPECT_EQ(comparisons::is_half_space(kind.name), kind.is_half_space());
    }
}

TEST(ModelKinds, OnALineHaveLines) {
    for (const ModelKind& kind : linked()) {
        const Case c = layer_case(8e-3);
        const auto model = made(kind.name, c);
        contact::LoadStep step = contact::press_step(c);
        step.friction = false;
        model->advance(step);
        EXPECT_EQ(model->surface().layout == contact::Surface::Layout::line, kind.is_on_line())
            << kind.name;
    }
}

TEST(ModelKinds, AreAsAccurateAsTheirSettings) {
    Case c = layer_case(8e-3);
    c.of<bem::Settings>().tolerance = 3e-5;
    for (const ModelKind& kind : linked()) {
        const double step = made(kind.name, c)->step_accuracy();
        if (kind.is_on_cells()) {
            EXPECT_EQ(step, c.of<bem::Settings>().tolerance);
        }
        if (kind.is_on_line()) {
            EXPECT_LE(step, contact::layer_springs_accuracy);
        }
    }
}

TEST(ModelKinds, OfOtherProgramsAssumeNothing) {
    Case c = layer_case(8e-3);
    const ModelKind& other = model_kind("a model of another program");
    EXPECT_FALSE(other.is_half_space() || other.is_on_line() || other.is_on_cells() ||
                 other.is_meshed() || other.is_read() || other.has_maps());
    EXPECT_TRUE(comparisons::left_out(c, "a model of another program").empty());
    EXPECT_TRUE(comparisons::couples(c, "a model of another program"));
    EXPECT_EQ(report::display_name("other-model"), "OTHER model");
}

TEST(MeasurementModels, AreThoseThatMeasurementsName) {
    const auto named = words(io::rig_key("measurement.models"));
    ASSERT_EQ(named.size(), io::measurement_models().size());
    for (std::size_t i = 0; i < named.size(); ++i) {
        const io::MeasurementModel& model = io::measurement_models()[i];
        SCOPED_TRACE(model.name);
        EXPECT_EQ(named[i], model.name);
        EXPECT_EQ(&io::measurement_model(named[i]), &model);
        EXPECT_NE(contact::find_model_kind(model.model), nullptr);
        EXPECT_EQ(model.kind().is_half_space(), !model.is_layer);
        for (const std::string rules : {model.rules, model.pressed_rules})
            EXPECT_EQ(rules.empty(), contact::find_model_kind(rules) == nullptr);
    }
    EXPECT_EQ(io::layer_theory().name, std::string("layer"));
    EXPECT_THROW(io::measurement_model("mdr"), std::out_of_range);
}

}  // namespace
}  // namespace tricontact::model_kind_test
