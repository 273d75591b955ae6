#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/run/figures.h"
#include "contact/bodies/height_map.h"
#include "contact/cells.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::rough_figures_test {
namespace {

/// E* = 1, rms slope 0.5, a square of 2 m: p/(E* h') = F_N/2.
contact::Case rough_case() {
    contact::Case c = synthetic::unit_case();
    c.indenter = {};
    c.indenter.shape = contact::Case::Shape::flat;
    c.indenter.roughness = contact::Roughness{.hurst = .8,
                                              .rms_slope = .5,
                                              .long_wavelength = 2,
                                              .roll_off = .5,
                                              .short_wavelength = .25,
                                              .seed = 1};
    c.load.indentation.reset();
    c.load.normal_force = .4;
    c.period = 2;
    c.of<contact::Cells>().spacing = 2. / 32;
    return c;
}

/// Pressed in two steps, then loaded, then rolled: kappa = 2 throughout.
Histories pressed() {
    contact::History history;
    history.model = "bem";
    for (const double force : {.2, .4}) {
        contact::StepRecord step;
        step.normal_force = force;
        step.contact_area = 4 * 2 * force / 2;
        history.steps.push_back(step);
    }
    history.steps.push_back(history.steps.back());
    history.steps.back().phase = .25;
    history.steps.back().contact_area = 3;
    return {history};
}

TEST(RoughFigures, SpectrumAndAreaOverLoad) {
    const auto figures = rough_figures(rough_case(), pressed());
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[0].id, "spectrum");
    EXPECT_EQ(figures[0].curves.back().name, "prescribed");
    EXPECT_EQ(figures[1].id, "contact_area");
    const report::Curve& area = figures[1].curves.front();
    ASSERT_EQ(area.x.size(), 2U);
    for (const int i : {0, 1}) {
        EXPECT_NEAR(area.x[i], .1 * (i + 1), 1e-12);
        EXPECT_NEAR(area.y[i], .2 * (i + 1), 1e-12);
    }
    EXPECT_NE(figures[1].caption.find("2.00 for BEM"), std::string::npos) << figures[1].caption;
}

TEST(RoughFigures, AMeasuredMapHasNoPrescribedSpectrum) {
    contact::Case c = rough_case();
    const contact::HeightMap map = make_roughness(*c.indenter.roughness, 32);
    c.indenter.roughness.reset();
    c.indenter.shape = contact::Case::Shape::height_map;
    c.indenter.height_map = std::make_shared<const contact::HeightMap>(map);
    const auto figures = rough_figures(c, pressed());
    ASSERT_EQ(figures.size(), 2U);
    EXPECT_EQ(figures[0].curves.size(), 1U);
}

TEST(RoughFigures, ARoughBallHasNoNominalArea) {
    contact::Case c = rough_case();
    c.indenter.shape = contact::Case::Shape::paraboloid;
    c.indenter.radius = 50;
    c.period.reset();
    ASSERT_EQ(rough_figures(c, pressed()).size(), 1U);
    EXPECT_TRUE(rough_figures(synthetic::unit_case(), synthetic::two_models()).empty());
}

}  // namespace
}  // namespace tricontact::comparisons::rough_figures_test
