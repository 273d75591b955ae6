// Rigs without a layer: crossed cylinders of steel that fret, by formulas put in by hand.

#include <cmath>
#include <numbers>

#include "contact/base/error.h"
#include "tests/unit/experiments/assumptions/rig_reports.h"

namespace tricontact::half_space_rig_test {
namespace {

using experiments::Rig;
using experiments::RigReport;
using experiments::Standing;
using std::numbers::pi;

constexpr double force = 500, radius = 10e-3, mu = .7, amplitude = 25e-6;
constexpr double e_star = 206e9 / (2 * .91);
const double a = std::cbrt(3 * force * radius / (4 * e_star));
const double p0 = 3 * force / (2 * pi * a * a);

RigReport fretting(const RigChanges& changes = {}) {
    return experiments::check_rig(changed(rig_file("fretting_crossed_cylinders"), changes));
}

/// Without changes, computed once.
const RigReport& unchanged() {
    static const RigReport report = fretting();
    return report;
}

TEST(HalfSpaceRig, ListsNothingThatNeedsALayer) {
    std::vector<std::string> names;
    for (const auto& one : unchanged().assumptions) names.push_back(one.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"large_specimens", "level_surface", "no_bulk_stress",
                                        "elastic_bodies", "smooth_surfaces", "unsaturated_contact",
                                        "no_fretting_heating", "no_fretting_wear"}));
}

TEST(HalfSpaceRig, NumbersOfCrossedCylinders) {
    const RigReport& report = unchanged();
    EXPECT_NEAR(value_of(report, "contact_slope"), a / radius, 1e-9);
    EXPECT_NEAR(value_of(report, "lost_indentation"),
                1.3 * 2.4 * force / (2 * pi * 206e9 * 20e-3 * a * a / radius), 1e-9);
    // 4 n U_a k_w p0 R/a^2.
    EXPECT_NEAR(
        value_of(report, "wear_ratio") / (4 * 1e5 * amplitude * 1e-17 * p0 * radius / (a * a)), 1,
        1e-9);
    EXPECT_NEAR(
        value_of(report, "frictional_heating") / (4 * mu * force * amplitude * 20 / (pi * a * 45)),
        1, 1e-9);
    // Sliding with mu = .7 yields at the trailing edge: Hamilton (1983).
    const double radial = .4 / 3, pulled = pi / 8 * mu;
    const double x = radial + 4.3 * pulled, y = -radial + .9 * pulled;
    EXPECT_NEAR(value_of(report, "von_mises_ratio"), p0 / 2e9 * std::sqrt(x * x - x * y + y * y),
                1e-9);
    EXPECT_EQ(assumption_of(report, "elastic_bodies").standing(), Standing::violated);
    // The path has no bulk stress.
    EXPECT_EQ(value_of(report, "stick_zone_shift"), 0);
}

TEST(HalfSpaceRig, WhatIsNotGivenIsNamed) {
    const RigReport report = fretting({{&Rig::t, {}},
                                       {&Rig::k_w, {}},
                                       {&Rig::f_c, {}},
                                       {&Rig::sigma, {}},
                                       {&Rig::Y_1, {}},
                                       {&Rig::Y_2, {}}});
    const std::map<std::string, std::string> missing = {
        {"large_specimens", "rig.specimen_thickness"},
        {"no_fretting_wear", "rig.wear_rate"},
        {"no_fretting_heating", "rig.cycle_frequency"},
        {"no_bulk_stress", "load.bulk_stress"},
        {"elastic_bodies", "substrate.yield_stress"}};
    for (const auto& [name, key] : missing) {
        EXPECT_EQ(assumption_of(report, name).standing(), Standing::not_testable) << name;
        EXPECT_EQ(assumption_of(report, name).missing, std::vector<std::string>{key});
    }
}

}  // namespace
}  // namespace tricontact::half_space_rig_test
