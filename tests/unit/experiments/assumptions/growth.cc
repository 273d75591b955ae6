#include <optional>

#include "experiments/assumptions/assumption_list.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::rig_growth_test {
namespace {

using experiments::Growth;
using experiments::Rig;
using experiments::Standing;

Rig thesis_sphere() {
    return rig_file("sphere_parallel");
}

TEST(RigGrowth, TheDifferenceDecides) {
    const Growth near{.amplitude = 1.14e-3,
                      .tangential_ratio = .31,
                      .half_space = {1.21, .001},
                      .layer = {1.19, .002}};
    const auto holds = experiments::growth_by_rolling(
        thesis_sphere(), [&](const Rig&) { return std::optional(near); });
    EXPECT_EQ(holds.standing(), Standing::holds);
    EXPECT_NEAR(holds.deciding_value(), 1 - 1.19 / 1.21, 1e-12);
    EXPECT_NE(holds.consequence.find("Rolled by 1.14 mm along F_T = 0.310 mu F_N"),
              std::string::npos)
        << holds.consequence;
    EXPECT_NE(holds.consequence.find("1.190 times the static one on the layer and 1.210 times"),
              std::string::npos)
        << holds.consequence;
    Growth far = near;
    far.layer = {1.4, .002};
    EXPECT_EQ(experiments::growth_by_rolling(thesis_sphere(),
                                             [&](const Rig&) { return std::optional(far); })
                  .standing(),
              Standing::violated);
}

TEST(RigGrowth, NothingIsSaidWhereNobodyKnows) {
    for (const experiments::RolledGrowth& none :
         {experiments::RolledGrowth(),
          experiments::RolledGrowth([](const Rig&) { return std::optional<Growth>(); })}) {
        const auto open = experiments::growth_by_rolling(thesis_sphere(), none);
        EXPECT_EQ(open.standing(), Standing::not_testable);
        EXPECT_TRUE(open.consequence.empty()) << open.consequence;
        EXPECT_FALSE(open.missing.empty());
    }
    // An elastic roller is none of the maps'.
    Rig soft = thesis_sphere();
    soft.E_1 = {5e6};
    const auto open = experiments::growth_by_rolling(soft, [](const Rig&) {
        return std::optional(Growth{1e-3, .3, {1.2}, {1.2}});
    });
    EXPECT_EQ(open.standing(), Standing::not_testable);
}

// What models compute at the values of a file says which ± it leaves out; what formulas compute has
// them.
TEST(RigGrowth, NamesTheErrorsThatItLeavesOut) {
    const experiments::RolledGrowth growth = [](const Rig&) {
        return std::optional(Growth{1e-3, .3, {1.2}, {1.2}});
    };
    const experiments::StaticShift shift = [](const Rig&, bool) { return 1e-6; };
    Rig rig = thesis_sphere();
    rig.uncertain = {"substrate.thickness", "rolling.amplitude"};
    const auto report = experiments::check_rig(rig, shift, growth);
    const std::string left_out = "the ± of substrate.thickness, rolling.amplitude are not in it";
    for (const auto& one : report.assumptions)
        EXPECT_EQ(one.consequence.find(left_out) != std::string::npos,
                  one.name == "uncoupled" || one.name == "growth_by_rolling")
            << one.name;
    rig.uncertain.clear();
    for (const auto& one : experiments::check_rig(rig, shift, growth).assumptions)
        EXPECT_EQ(one.consequence.find("not in it"), std::string::npos) << one.name;
}

}  // namespace
}  // namespace tricontact::rig_growth_test
