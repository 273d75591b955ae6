// What is known of an adhesive case without a run: both ends of Tabor's parameter, units, and where
// nothing is known.

#include "comparisons/adhesion/adhesion_forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tricontact::adhesion_forms_test {

using comparisons::adhesive_forms;
using contact::Adhesion;
using contact::Case;
using std::numbers::pi;

constexpr double radius = 5e-3, work = .06;

Case sphere(const Adhesion& adhesion) {
    Case c;
    c.models = {"mdr"};
    c.indenter.radius = radius;
    c.substrate = {1.5e6, .5};
    c.friction.coefficient = .5;
    c.load.normal_force = 4e-3;
    c.load.tangential_ratio = 0;
    c.adhesion = adhesion;
    return c;
}

// Johnson, Kendall and Roberts, E* = 2 MPa.
TEST(AdhesionForms, OfNoRangeAreClosed) {
    const auto forms = adhesive_forms(sphere({.work = work, .range = 0}));
    ASSERT_TRUE(forms);
    const double unit = pi * work * radius, force = 4e-3;
    const double cube =
        3 * radius / 8e6 * (force + 3 * unit + std::sqrt(6 * unit * force + 9 * unit * unit));
    EXPECT_NEAR(forms->contact_radius / std::cbrt(cube), 1, 1e-9);
    EXPECT_NEAR(forms->pull_off.force / (1.5 * unit), 1, 1e-9);
}

// A short range is all but none, a long one that of Derjaguin, Muller and Toporov: in units of the
// case. The former misses the width of the ring, of O(1/lambda^2).
TEST(AdhesionForms, OfARangeLieBetweenBothTheories) {
    const double unit = pi * work * radius;
    const Case close = sphere({.work = work, .range = 1e-8}), none = sphere({.work = work});
    EXPECT_NEAR(adhesive_forms(close)->contact_radius / adhesive_forms(none)->contact_radius, 1,
                2e-3);
    EXPECT_NEAR(adhesive_forms(close)->pull_off.force / unit, 1.5, 2e-3);
    const Case far = sphere({.work = work, .range = 1e-2});
    EXPECT_NEAR(adhesive_forms(far)->pull_off.force / unit, 2, 5e-3);
    const double dmt = std::cbrt(3 * radius / 8e6 * (4e-3 + 2 * unit));
    EXPECT_NEAR(adhesive_forms(far)->contact_radius / dmt, 1, 1e-2);
}

TEST(AdhesionForms, PeakStressSaysTheRange) {
    Adhesion by_stress{.work = work};
    by_stress.peak_stress = work / 2e-6;
    EXPECT_DOUBLE_EQ(*comparisons::tabor_parameter(sphere(by_stress)),
                     *comparisons::tabor_parameter(sphere({.work = work, .range = 2e-6})));
}

TEST(AdhesionForms, AreSilentWhereNothingIsKnown) {
    Case layer = sphere({.work = work});
    layer.layer.thickness = 1e-3;
    EXPECT_FALSE(adhesive_forms(layer));
    EXPECT_FALSE(
        adhesive_forms(sphere({.work = work, .range = 1e-6, .law = Adhesion::Law::exponential})));
    Case none = sphere({});
    none.adhesion.reset();
    EXPECT_FALSE(adhesive_forms(none));
    EXPECT_TRUE(comparisons::adhesion_sentences(none).empty());
    EXPECT_TRUE(comparisons::adhesive_values(none).empty());
}

// 44 and .044 of Tabor's parameter: (R w^2/(E*^2 range^3))^(1/3).
TEST(AdhesionForms, SentencesTellTheRegime) {
    const auto text = [](double range) {
        std::string all;
        for (const auto& one :
             comparisons::adhesion_sentences(sphere({.work = work, .range = range})))
            all += one;
        return all;
    };
    EXPECT_NE(text(1e-7).find("short-ranged"), std::string::npos) << text(1e-7);
    EXPECT_NE(text(1e-6).find("Maugis' transition"), std::string::npos) << text(1e-6);
    EXPECT_NE(text(1e-3).find("long-ranged"), std::string::npos) << text(1e-3);
}

// Of a range the curves of none and of a long one stand beside: the least forces are those of
// pull-off, which is between both, and Hertz' contact begins with -2 pi w R.
TEST(AdhesionForms, CurvesLieBetweenTheirLimits) {
    const Case c = sphere({.work = work, .peak_stress = 16e3});
    const auto curves = comparisons::adhesive_equilibria(c);
    ASSERT_EQ(curves.size(), 3u);
    const double unit = pi * work * radius;
    std::array<double, 3> least{};
    for (int k = 1; k <= 2000; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            least[i] = std::min(least[i], curves[i].at(1e-7 * k)[1] / unit);
    EXPECT_NEAR(least[0], -adhesive_forms(c)->pull_off.force / unit, 1e-5);
    EXPECT_NEAR(least[1], -1.5, 1e-5);
    EXPECT_NEAR(least[2], -2, 1e-5);
    EXPECT_EQ(comparisons::adhesive_equilibria(sphere({.work = work, .range = 0})).size(), 1u);
}

}  // namespace tricontact::adhesion_forms_test
