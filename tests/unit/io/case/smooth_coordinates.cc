// Keys in which answers are smooth: the layer's thickness over the contact, F_T over the limit.

#include <gtest/gtest.h>

#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"
#include "tests/unit/io/sphere_case.h"

namespace tricontact::io::smooth_coordinates_test {
namespace {

using contact::Case;

const std::string rolling = "[rolling]\namplitude_ratio = 0.24\n";
const std::string layer = "[substrate]\nthickness = \"8 mm\"\nbase = \"frictionless\"\n";

Case parsed(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return parse_case(text, "smooth.toml", overrides);
}

TEST(ThicknessRatio, IsThatToTheContactDiameterOnTheHalfSpace) {
    for (const std::string load :
         {"load.normal_force=21.1 N", "load.normal_force=300 N", "load.indentation=0.4 mm"})
        for (const std::string shape : {"paraboloid", "sphere"}) {
            const Case c = parsed(
                loaded_sphere, {"substrate.thickness_ratio=0.9", load, "indenter.shape=" + shape});
            EXPECT_DOUBLE_EQ(c.layer.thickness.value(),
                             1.8 * contact::half_space_scales(c).contact_radius)
                << load;
            EXPECT_FALSE(c.kept.find<io::LayersInput>());
        }
}

TEST(ThicknessRatio, IsOfTheMeanLoad) {
    const Case c = parsed(loaded_sphere + rolling, {"substrate.thickness_ratio=0.9"});
    const Case oscillating = parsed(loaded_sphere + rolling, {"substrate.thickness_ratio=0.9",
                                                              "load.normal_amplitude_ratio=0.3"});
    EXPECT_EQ(c.layer.thickness, oscillating.layer.thickness);
}

TEST(ThicknessRatio, OfACylinderIsThatToTheWidth) {
    const Case c = parsed(loaded_sphere, {"substrate.thickness_ratio=2", "indenter.shape=cylinder",
                                          "indenter.length=80 mm"});
    EXPECT_DOUBLE_EQ(c.layer.thickness.value(), 4 * contact::half_space_scales(c).half_widths[0]);
}

TEST(ThicknessRatio, ResolvedCaseHasTheThickness) {
    const Case c = parsed(loaded_sphere, {"substrate.thickness_ratio=0.9"});
    const std::string text = write_case(c);
    EXPECT_EQ(text.find("thickness_ratio"), std::string::npos) << text;
    EXPECT_EQ(write_case(parse_case(text, "resolved.toml")), text);
    EXPECT_EQ(parse_case(text, "resolved.toml").layer.thickness, c.layer.thickness);
}

TEST(ThicknessRatio, ReplacesAThicknessAndKeepsWhatNeedsOne) {
    const std::string text = [] {
        std::string sphere = loaded_sphere;
        sphere.replace(sphere.find("[substrate]\n"), 12, layer);
        return sphere;
    }();
    const Case c = parsed(text, {"substrate.thickness_ratio=0.9"});
    EXPECT_EQ(c.layer.base, Case::Base::frictionless);
    EXPECT_NE(c.layer.thickness, .008);
    // And back.
    std::string by_ratio = text;
    by_ratio.replace(by_ratio.find("thickness = \"8 mm\""), 18, "thickness_ratio = 0.9");
    EXPECT_EQ(parsed(by_ratio).layer.thickness, c.layer.thickness);
    EXPECT_EQ(parsed(by_ratio).layer.base, Case::Base::frictionless);
    const Case back = parsed(by_ratio, {"substrate.thickness=8 mm"});
    EXPECT_EQ(back.layer.thickness, .008);
    EXPECT_EQ(back.layer.base, Case::Base::frictionless);
    EXPECT_THROW(parsed(by_ratio, {"substrate.thickness=8 mm", "substrate.thickness_ratio=1"}),
                 contact::InputError);
}

TEST(LimitFraction, IsKeptAndWritten) {
    const Case c = parsed(loaded_sphere + rolling, {"load.limit_fraction=1.5"});
    EXPECT_EQ(c.load.limit_fraction, 1.5);
    EXPECT_FALSE(c.load.tangential_ratio);
    const std::string text = write_case(c);
    EXPECT_NE(text.find("limit_fraction = 1.5"), std::string::npos) << text;
    EXPECT_EQ(write_case(parse_case(text, "resolved.toml")), text);
    EXPECT_FALSE(
        parse_case(text, "resolved.toml", {"load.tangential_ratio=0.3"}).load.limit_fraction);
}

TEST(LimitExcess, IsTheShareOfTheWayFromTheLimitToSliding) {
    const Case c = parsed(loaded_sphere + rolling, {"load.limit_excess=0.25"});
    EXPECT_TRUE(c.load.is_by_limit());
    EXPECT_STREQ(c.load.limit_key(), "load.limit_excess");
    EXPECT_DOUBLE_EQ(c.load.ratio_by_limit(.6), .7);
    EXPECT_FALSE(
        parse_case(write_case(c), "resolved.toml", {"load.limit_fraction=0.3"}).load.limit_excess);
    EXPECT_THROW(parsed(loaded_sphere + rolling, {"load.limit_excess=1"}), contact::InputError);
}

}  // namespace
}  // namespace tricontact::io::smooth_coordinates_test
