#include "app/models/make_model.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/base/error.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/run.h"
#include "fem/settings.h"
#include "mdr/settings.h"

namespace tricontact::make_model_test {
namespace {

using app::model_makers;
using contact::Case;

/// A paraboloid on a half-space or a layer, all scales other than 1.
Case pressed_case() {
    Case c;
    c.indenter.radius = .04;
    c.substrate = {5e6, .5};
    c.friction.coefficient = .6;
    c.load.normal_force = 20;
    c.load.tangential_ratio = .5;
    return c;
}

std::string why_refused(const std::string& model, const Case& c) {
    try {
        model_makers().make(model, c, 1, contact::silent);
    } catch (const contact::InputError& why) {
        return why.what();
    }
    return {};
}

TEST(ModelMakers, MakeEachKnownModelByItsName) {
    Case c = pressed_case();
    c.layer.thickness = 8e-3;
    c.of<contact::Cells>().spacing = 5e-4;
    for (const contact::ModelKind& kind : app::known_models()) {
        EXPECT_TRUE(model_makers().has(kind.name));
        if (kind.is_read() || kind.is_meshed()) continue;  // run nothing; load a module
        EXPECT_EQ(model_makers().make(kind.name, c, 1, contact::silent)->name(), kind.name);
    }
}

TEST(ModelMakers, RefuseByName) {
    EXPECT_FALSE(model_makers().has("fast"));
    EXPECT_NE(why_refused("fast", pressed_case()).find("without the model fast"),
              std::string::npos);
    const std::string atlas = why_refused(contact::models::atlas, pressed_case());
    EXPECT_NE(atlas.find("tricontact predict"), std::string::npos) << atlas;
}

// Springs at twice the distance, but one: halves that fall on springs of the whole agree by
// accident.
TEST(ModelMakers, CoarserSpringsAndCells) {
    Case c = pressed_case();
    c.of<mdr::Settings>().springs = 400;
    c.of<contact::Cells>().spacing = 5e-4;
    c.of<contact::Cells>().per_radius.reset();
    const auto springs =
        model_makers().make_coarser(contact::models::mdr, c, 2, 1, contact::silent);
    EXPECT_EQ(springs.c.of<mdr::Settings>().springs, 199);
    const auto cells = model_makers().make_coarser(contact::models::bem, c, 2, 1, contact::silent);
    EXPECT_EQ(cells.c.of<contact::Cells>().spacing, 1e-3);
    EXPECT_EQ(c.of<contact::Cells>().spacing, 5e-4);
    const auto surface = [](const contact::CoarserModel& coarser) {
        contact::run(coarser.c, *coarser.model);
        return coarser.model->surface();
    };
    EXPECT_NEAR(surface(cells).spacing[0], 1e-3, 1e-15);
}

// The elements of a line on a layer: those of the case's settings, and as far as the thickness
// allows.
TEST(ModelMakers, CoarserElementsOfALayersLine) {
    Case c = pressed_case();
    c.layer.thickness = 8e-3;
    const auto coarser = [&](double factor) {
        return model_makers().make_coarser(contact::models::mdr_layer, c, factor, 1,
                                           contact::silent);
    };
    EXPECT_EQ(coarser(2).c.of<mdr::Settings>().elements_per_radius, 50);
    EXPECT_EQ(coarser(.5).c.of<mdr::Settings>().elements_per_radius, 200);
    c.layer.thickness = 1e-4;  // of which elements are a quarter at most
    try {
        coarser(8);
        FAIL() << "not refused";
    } catch (const contact::InputError& why) {
        EXPECT_NE(std::string(why.what()).find("increase mdr.elements_per_radius"),
                  std::string::npos);
    }
}

TEST(ModelMakers, NoMeshIsCoarserThanThatOfAFile) {
    Case c = pressed_case();
    c.layer.thickness = 8e-3;
    c.of<fem::Settings>().mesh = "layer.msh";
    try {
        model_makers().make_coarser(contact::models::fem, c, 2, 1, contact::silent);
        FAIL() << "not refused";
    } catch (const contact::InputError& why) {
        EXPECT_NE(std::string(why.what()).find("the mesh is a file's"), std::string::npos);
    }
}

// Springs are as far from Hertz' solution as the square of their distance over the contact radius,
// more or less by where the edge falls between them.
TEST(ModelRunner, RunsAModelOnTwoMeshes) {
    Case c = pressed_case();
    c.of<mdr::Settings>().springs = 100;
    const contact::ModelRunner runner(model_makers(), 1);
    const double exact = contact::half_space_scales(c).indentation;
    const double fine = runner.history_of(contact::models::mdr, c).scales.indentation;
    const double coarse = runner.history_of_coarser(contact::models::mdr, c).scales.indentation;
    EXPECT_NEAR(fine / exact, 1, 4. / (100 * 100));
    EXPECT_NEAR(coarse / exact, 1, 4. / (49 * 49));
    EXPECT_NE(coarse, fine);
}

}  // namespace
}  // namespace tricontact::make_model_test
