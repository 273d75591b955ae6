// Whether adhesion counts: on each side of the threshold, by both theories, and without its datum.
#include <cmath>

#include "experiments/assumptions/assumption_list.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::adhesion_assumption_test {
namespace {

using experiments::Rig;
using experiments::Standing;

Rig sphere(double radius, double force, double young, double work) {
    Rig rig;
    rig.R = radius;
    rig.E_1 = 206e9;
    rig.nu_1 = 0.3;
    rig.b = 10 * radius;
    rig.E_2 = young;
    rig.nu_2 = 0.5;
    rig.F_N = force;
    rig.Dgamma = {work, work / 10};
    return rig;
}

// F_off/F_N = 3/2 pi w R/F_N, and a of JKR: 1 + sqrt(6 pi w R/F_N)/3 for small adhesion.
TEST(Adhesion, OfTheThesisRigIsNone) {
    const auto a = experiments::no_adhesion(sphere(40e-3, 21.1, 5.2e6, .05));
    EXPECT_EQ(a.standing(), Standing::holds);
    EXPECT_NEAR(a.deciding_value(), 1.5 * M_PI * .05 * 40e-3 / 21.1, 1e-12);
    EXPECT_NEAR(a.criteria[1].calculation.result.value,
                std::sqrt(6 * M_PI * .05 * 40e-3 / 21.1) / 3, 3e-4);
    EXPECT_NE(a.consequence.find("By Johnson, Kendall and Roberts"), std::string::npos)
        << a.consequence;
}

TEST(Adhesion, OfASmallBallOnSoftRubberIsAViolation) {
    const auto a = experiments::no_adhesion(sphere(5e-3, 20e-3, 1e6, .05));
    EXPECT_EQ(a.standing(), Standing::violated);
    // The error of the work of adhesion is propagated: F_off is in proportion to it.
    EXPECT_NEAR(a.criteria[0].calculation.result.standard_error / a.deciding_value(), .1, 1e-6);
}

TEST(Adhesion, OfStiffSmallSpheresIsThatOfDerjaguinMullerAndToporov) {
    const auto a = experiments::no_adhesion(sphere(1e-7, 1e-5, 100e9, .03));
    EXPECT_NE(a.consequence.find("Derjaguin, Muller and Toporov"), std::string::npos)
        << a.consequence;
    EXPECT_NEAR(a.deciding_value(), 2 * M_PI * .03 * 1e-7 / 1e-5, 1e-12);
}

// A thin incompressible layer holds up to 3 pi w R, twice what the half-space does; a thick one the
// same.
TEST(Adhesion, OnALayerIsThatOfTheLayer) {
    for (const double thickness : {.02e-3, 500e-3}) {
        Rig rig = sphere(5e-3, 20e-3, 1e6, .05);
        rig.b = thickness;
        const auto a = experiments::no_adhesion(rig);
        const auto value = [&](const char* name) { return a.find(name)->result.value; };
        const double ratio = value("layer_pull_off_ratio") / value("pull_off_ratio");
        if (thickness > 1e-3) {
            EXPECT_NEAR(ratio, 1, 1e-2);
            EXPECT_NEAR(value("layer_adhesive_radius_change"), value("adhesive_radius_change"),
                        1e-2);
        } else {
            EXPECT_GT(ratio, 1.4);
            EXPECT_LT(ratio, 2);
        }
        EXPECT_NE(a.consequence.find("On the layer it widens"), std::string::npos);
    }
}

// Of a body that no closed form has, by runs that the caller made; of a ball that deforms on a
// layer beside the half-space's.
TEST(Adhesion, OfOtherBodiesIsThatOfRuns) {
    Rig rig = sphere(40e-3, 21.1, 5.2e6, .05);
    rig.attracted = {{.01, 4.55e-3, 4.5e-3}, {.02, 4.1e-3, 4e-3}};
    const auto near = experiments::no_adhesion_of_body(rig);
    EXPECT_EQ(near.standing(), Standing::holds);
    EXPECT_NEAR(near.find("layer_pull_off_ratio")->result.value, .02 / 21.1, 1e-12);
    EXPECT_NEAR(near.find("layer_adhesive_radius_change")->result.value, .025, 1e-12);
    rig.attracted->layer.radius = 4.4e-3;
    EXPECT_EQ(experiments::no_adhesion_of_body(rig).standing(), Standing::violated);
    rig.E_1 = 3e6;
    EXPECT_EQ(experiments::no_adhesion(rig).standing(), Standing::violated);
    rig.attracted->why_none = "no body of revolution";
    EXPECT_EQ(experiments::no_adhesion_of_body(rig).standing(), Standing::not_testable);
    EXPECT_NE(experiments::no_adhesion(rig).consequence.find("no body of revolution"),
              std::string::npos);
    rig.attracted.reset();
    EXPECT_EQ(experiments::no_adhesion_of_body(rig).standing(), Standing::not_testable);
}

TEST(Adhesion, WithoutItsWorkIsNotTestable) {
    Rig rig = sphere(40e-3, 21.1, 5.2e6, .05);
    rig.Dgamma = {};
    const auto a = experiments::no_adhesion(rig);
    EXPECT_EQ(a.standing(), Standing::not_testable);
    EXPECT_EQ(a.missing, std::vector<std::string>{"rig.work_of_adhesion"});
    EXPECT_TRUE(a.consequence.empty());
}

}  // namespace
}  // namespace tricontact::adhesion_assumption_test
