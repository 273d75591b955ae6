// Ratios of the catalogue: beside what codes state, and beside the numbers they follow from.

#include "benchmarks/problems/target_reference.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/comparison/comparison.h"
#include "benchmarks/submissions/table_field.h"
#include "contact/base/error.h"
#include "contact/half_space_scales.h"
#include "theory/creep_law.h"
#include "theory/friction_pressing.h"
#include "theory/rolling/kalker.h"

namespace tricontact::benchmarks::target_reference_test {
namespace {

/// Of the targets alone, beside the closed radius of the contact.
Reference targets_of(const std::string& name) {
    const Problem& problem = required_problem(name);
    Reference reference;
    reference.c = problem.make_case();
    reference.geometry = reference.c.is_line_contact() ? Geometry::plane : Geometry::axisymmetric;
    reference.contact_radius = contact::half_space_scales(reference.c).contact_radius;
    add_targets(reference, problem);
    return reference;
}

/// On three meshes that have one value each.
Comparison stated(const std::string& name, const std::string& lines, double tolerance = .01) {
    Submission s{.problem = name};
    s.tolerances.usual = tolerance;
    for (const double h : {.4, .2, .1})
        s.meshes.push_back(parse_table(fmt::format("# size = {} mm\n{}", h, lines), "a.csv"));
    check_stated_targets(s, find_problem(name));
    return compare(std::move(s), targets_of(name));
}

const ComparedNumber& number(const Comparison& c, const std::string& key) {
    return *std::ranges::find(c.numbers, key, &ComparedNumber::key);
}

TEST(TargetReference, StickRadiusOfPressingIsJudged) {
    const double exact = theory::spence_stick_ratio(1.4);
    EXPECT_EQ(stated("spence", fmt::format("# stick_ratio = {:.10g}\n", exact), .02).standing,
              Standing::pass);
    // Areas say it, too.
    const Comparison areas = stated("spence",
                                    fmt::format("# stick_area = {:.10g} mm2\n# contact_area = 10 "
                                                "mm2\n",
                                                10 * exact * exact),
                                    .02);
    EXPECT_NEAR(*number(areas, "stick_ratio").values.back(), exact, 1e-9);
    EXPECT_EQ(areas.standing, Standing::pass);
    // The ratio of areas in place of that of radii.
    EXPECT_EQ(
        stated("spence", fmt::format("# stick_ratio = {:.10g}\n", exact * exact), .02).standing,
        Standing::fail);
    // The closed form itself is known to 1 % here.
    EXPECT_EQ(stated("spence", fmt::format("# stick_ratio = {:.10g}\n", exact), .005).standing,
              Standing::not_resolved);
}

TEST(TargetReference, CreepageOfCarterIsJudgedByItsRatio) {
    const contact::Case c = required_problem("carter").make_case();
    const double scale =
        c.friction_coefficient() * contact::half_space_scales(c).contact_radius / c.indenter.radius;
    const double ratio = 1 - std::sqrt(1 - .56);
    const auto of_creepage = [&](double creepage) {
        return stated("carter", fmt::format("# creepage = {:.10g}\n", creepage));
    };
    const Comparison exact = of_creepage(scale * ratio);
    EXPECT_NEAR(*number(exact, "creepage_ratio").values.back(), ratio, 1e-8);
    EXPECT_EQ(exact.standing, Standing::pass);
    EXPECT_EQ(number(exact, "creepage_ratio").title, "creepage over mu a/R");
    // The whole width in place of the half.
    EXPECT_EQ(of_creepage(2 * scale * ratio).standing, Standing::fail);
    // In plane strain areas are widths.
    EXPECT_EQ(stated("carter", "# stick_area = 6.63325 mm\n# contact_area = 10 mm\n").standing,
              Standing::pass);
}

TEST(TargetReference, KalkersCoefficientFollowsFromTheForce) {
    const contact::Case c = required_problem("kalker_coefficients").make_case();
    const double a = contact::half_space_scales(c).contact_radius,
                 shear_modulus = c.substrate.young / (2 * (1 + c.substrate.poisson));
    const double force = 4.12 * shear_modulus * a * a * .001;
    const auto of_force = [&](double newton) {
        return stated("kalker_coefficients",
                      fmt::format("# tangential_force = {:.10g} N\n", newton));
    };
    EXPECT_EQ(of_force(force).standing, Standing::pass);
    EXPECT_EQ(of_force(-force).standing, Standing::pass) << "on the other body";
    EXPECT_NEAR(number(of_force(force), "c11").difference, 0, 1e-8);
    // E in place of G.
    EXPECT_EQ(of_force(2.5 * force).standing, Standing::fail);
    for (const char* line : {"# c22 = 3.67\n", "# C23 = 1.47\n", "# C33 = 1.19\n"})
        EXPECT_EQ(stated("kalker_coefficients", line).standing, Standing::pass) << line;
    EXPECT_EQ(stated("kalker_coefficients", "# c22 = 4.12\n").standing, Standing::fail);
}

TEST(TargetReference, StiffnessWithoutSlipIsJudged) {
    const contact::Case c = required_problem("stuck_pressing").make_case();
    const double a = contact::half_space_scales(c).contact_radius;
    const double exact = theory::stuck_normal_stiffness_ratio(0) * 4 * c.substrate.young / 2 * a;
    EXPECT_EQ(
        stated("stuck_pressing", fmt::format("# normal_stiffness = {:.10g} N/m\n", exact)).standing,
        Standing::pass);
    // Pressed without friction.
    EXPECT_EQ(stated("stuck_pressing", "# stiffness_ratio = 1\n").standing, Standing::fail);
}

TEST(TargetReference, ShiftsAreOverThatOfAllSlipping) {
    for (const auto& [name, key, value] :
         {std::tuple{"oscillating_rolling", "settled_shift", .5594},
          std::tuple{"ratcheting", "shift_increment", .15355},
          std::tuple{"cylinder_friction", "shift", .483422}}) {
        const double scale =
            contact::half_space_scales(required_problem(name).make_case()).unit_shift;
        const auto of_shift = [&](double metres) {
            return stated(name, fmt::format("# {} = {:.10g} m\n", key, metres));
        };
        EXPECT_EQ(of_shift(value * scale).standing, Standing::pass) << name;
        EXPECT_EQ(of_shift(1.05 * value * scale).standing, Standing::fail) << name;
    }
    // Springs are another problem.
    EXPECT_EQ(stated("oscillating_rolling", "# settled_shift_ratio = 0.65202\n").standing,
              Standing::fail);
}

TEST(TargetReference, StressesBelowAreStated) {
    EXPECT_EQ(
        stated("subsurface", "# von_mises_ratio = 0.62\n# von_mises_depth_ratio = 0.481\n", .02)
            .standing,
        Standing::pass);
    EXPECT_EQ(stated("subsurface", "# von_mises_ratio = 0.31\n").standing, Standing::fail)
        << "the largest shear stress in its place";
}

TEST(TargetReference, RefusesTargetsOfOtherProblems) {
    const auto refusal = [](const std::string& name, const std::string& line) -> std::string {
        try {
            stated(name, line);
        } catch (const contact::InputError& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_NE(refusal("carter", "# c11 = 4\n")
                  .find("c11: is no target of carter; its targets of this kind are creepage_ratio, "
                        "stick_ratio"),
              std::string::npos);
    EXPECT_NE(refusal("layer_pressed", "# force_ratio = .4\n").find("is no target"),
              std::string::npos);
}

}  // namespace
}  // namespace tricontact::benchmarks::target_reference_test
