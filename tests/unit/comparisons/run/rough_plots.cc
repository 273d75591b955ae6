#include <gtest/gtest.h>

#include <algorithm>

#include "comparisons/run/plots.h"
#include "contact/bodies/height_map.h"
#include "tests/unit/comparisons/history.h"

namespace tricontact::comparisons::rough_plots_test {
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
    c.bem.period = 2;
    c.bem.spacing = 2. / 32;
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

TEST(RoughPlots, SpectrumAndAreaOverLoad) {
    const auto plots = rough_plots(rough_case(), pressed());
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].name, "spectrum");
    EXPECT_NE(plots[0].picture.script.find("prescribed"), std::string::npos);
    EXPECT_EQ(plots[1].name, "contact_area");
    EXPECT_NE(plots[1].picture.script.find("EOD\n0.1 0.2 \n0.2 0.4 \nEOD"), std::string::npos)
        << plots[1].picture.script;
    EXPECT_NE(plots[1].caption.find("2.00 for BEM"), std::string::npos) << plots[1].caption;
    for (const Drawing& drawing : draw_all(plots)) {
        EXPECT_GT(std::count(drawing.svg.begin(), drawing.svg.end(), '\n'), 60);
        EXPECT_NE(drawing.png.find("IEND"), std::string::npos);
    }
}

TEST(RoughPlots, AMeasuredMapHasNoPrescribedSpectrum) {
    contact::Case c = rough_case();
    const contact::HeightMap map = make_roughness(*c.indenter.roughness, 32);
    c.indenter.roughness.reset();
    c.indenter.shape = contact::Case::Shape::height_map;
    c.indenter.height_map = std::make_shared<const contact::HeightMap>(map);
    const auto plots = rough_plots(c, pressed());
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].picture.script.find("prescribed"), std::string::npos);
}

TEST(RoughPlots, ARoughBallHasNoNominalArea) {
    contact::Case c = rough_case();
    c.indenter.shape = contact::Case::Shape::paraboloid;
    c.indenter.radius = 50;
    c.bem.period.reset();
    ASSERT_EQ(rough_plots(c, pressed()).size(), 1U);
    EXPECT_TRUE(rough_plots(synthetic::unit_case(), synthetic::two_models()).empty());
}

}  // namespace
}  // namespace tricontact::comparisons::rough_plots_test
