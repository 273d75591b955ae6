// The numbers of the catalogue beside closed forms and exact references, its texts beside the rules
// of documents.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "benchmarks/problems/problem.h"
#include "benchmarks/reference/quantity_units.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"
#include "io/case/case_reader.h"
#include "theory/cattaneo_mindlin.h"
#include "theory/creep_law.h"
#include "theory/friction_pressing.h"
#include "theory/layer/elastic_layer.h"
#include "theory/layer/line_contact.h"
#include "theory/oscillating_cylinder.h"
#include "theory/rolling/kalker.h"
#include "theory/rolling/oscillating_rolling.h"
#include "theory/torsion.h"

namespace tricontact::benchmark_catalogue_test {
namespace {

using benchmarks::Problem;
using benchmarks::Target;

const Problem& problem(const std::string& name) {
    return benchmarks::required_problem(name);
}

/// The number of the solution.
const Target& target(const std::string& name, const std::string& key) {
    for (const Target& one : problem(name).targets)
        if (one.key == key && one.is_solution) return one;
    throw std::out_of_range(name + " has no " + key);
}

/// Within its bar and the seven digits that are written.
void expect_target(const std::string& name, const std::string& key, double exact) {
    const Target& one = target(name, key);
    EXPECT_NEAR(one.value, exact, one.bar + 3e-7 * std::abs(exact)) << name << ": " << key;
}

TEST(BenchmarkCatalogue, HasTheProblemsOfTheField) {
    EXPECT_GE(benchmarks::catalogue().size(), 18u);
    for (const char* name : {"hertz_sphere",
                             "two_spheres",
                             "cylinder_on_block",
                             "layer_pressed",
                             "layer_pressed_nearly_incompressible",
                             "layer_pressed_friction",
                             "layer_shifted",
                             "cattaneo_sphere",
                             "mindlin_cycle",
                             "cylinder_friction",
                             "spence",
                             "carter",
                             "bentall_johnson",
                             "kalker_coefficients",
                             "lubkin",
                             "subsurface",
                             "oscillating_rolling",
                             "patch_test",
                             "wedge",
                             "complete_punch",
                             "rounded_punch",
                             "rounded_punch_plane",
                             "hemisphere",
                             "hemisphere_on_layer",
                             "ball_between_plates",
                             "cylinder_between_plates",
                             "pin_in_hole",
                             "receding_layer",
                             "two_hemispheres",
                             "nafems_roller",
                             "nafems_punch",
                             "cattaneo_two_cylinders",
                             "spence_two_bodies",
                             "carter_two_cylinders",
                             "complete_punch_two_bodies"})
        EXPECT_NE(benchmarks::find_problem(name), nullptr) << name;
    EXPECT_EQ(benchmarks::find_problem("layer-pressed"), benchmarks::find_problem("layer_pressed"));
    EXPECT_EQ(benchmarks::find_problem("no_problem"), nullptr);
}

TEST(BenchmarkCatalogue, IsWhole) {
    std::set<std::string> names;
    for (const Problem& one : benchmarks::catalogue()) {
        EXPECT_TRUE(names.insert(one.name).second) << one.name;
        EXPECT_FALSE(one.traps.empty()) << one.name;
        EXPECT_FALSE(one.sources.empty()) << one.name;
        EXPECT_TRUE(std::ranges::any_of(one.targets, &Target::is_solution)) << one.name;
        EXPECT_TRUE(!one.twin || benchmarks::find_problem(*one.twin)) << one.name;
    }
}

TEST(BenchmarkCatalogue, CasesAreReadAndHaveModels) {
    for (const Problem& one : benchmarks::catalogue()) {
        if (!one.has_case()) continue;
        const contact::Case c = one.make_case();
        EXPECT_FALSE(c.models.empty()) << one.name;
        EXPECT_FALSE(c.title.empty()) << one.name;
        EXPECT_EQ(io::write_case(io::parse_case(io::write_case(c), one.name)), io::write_case(c));
    }
}

TEST(BenchmarkCatalogue, ProblemsWithClosedFormsHaveNoCase) {
    EXPECT_THROW(problem("patch_test").make_case(), contact::InputError);
}

TEST(BenchmarkCatalogue, HasHertzNumbers) {
    for (const char* name : {"hertz_sphere", "two_spheres", "cylinder_on_block", "cattaneo_sphere",
                             "cylinder_friction"}) {
        const auto scales = contact::half_space_scales(problem(name).make_case());
        expect_target(name, "contact_radius", scales.contact_radius);
        expect_target(name, "peak_pressure", scales.peak_pressure);
    }
    expect_target("hertz_sphere", "normal_force",
                  contact::half_space_scales(problem("hertz_sphere").make_case()).normal_force);
}

// SSNV104: the three-dimensional model is no solution of Hertz' problem, and it says so.
TEST(BenchmarkCatalogue, ShowsWhatIsNoSolutionBeside) {
    const auto& targets = problem("two_spheres").targets;
    const auto other =
        std::ranges::find_if(targets, [](const Target& t) { return !t.is_solution; });
    ASSERT_NE(other, targets.end());
    EXPECT_NEAR(other->value / target("two_spheres", "peak_pressure").value, 1.135, 1e-3);
    EXPECT_FALSE(other->remark.empty());
}

TEST(BenchmarkCatalogue, HasTheNumbersOfTheExactLayer) {
    for (const char* name : {"layer_pressed", "layer_pressed_nearly_incompressible"}) {
        const contact::Case c = problem(name).make_case();
        const auto exact = theory::solve_layer_contact(
            {c.substrate, *c.layer.thickness, theory::LayerBase::bonded},
            *c.make_axisymmetric_indenter(),
            {contact::NormalControl::Kind::indentation, *c.load.indentation});
        expect_target(name, "normal_force", exact.normal_force);
        expect_target(name, "contact_radius", exact.contact_radius);
        expect_target(name, "peak_pressure", exact.centre_pressure);
    }
    const contact::Case c = problem("cylinder_on_layer").make_case();
    const auto line = theory::solve_line_contact(
        {c.substrate, *c.layer.thickness, theory::LayerBase::bonded}, c.indenter.radius,
        {theory::LineControl::Kind::indentation, *c.load.indentation});
    expect_target("cylinder_on_layer", "normal_force", line.load);
    expect_target("cylinder_on_layer", "contact_radius", line.half_width);
    expect_target("cylinder_on_layer", "peak_pressure", line.centre_pressure);
}

TEST(BenchmarkCatalogue, HasTheNumbersOfCattaneoAndMindlin) {
    const contact::Case c = problem("cattaneo_sphere").make_case();
    const auto scales = contact::half_space_scales(c);
    const double f = *c.load.tangential_ratio;
    expect_target("cattaneo_sphere", "shift", scales.unit_shift * theory::static_shift_ratio(f));
    expect_target(
        "cattaneo_sphere", "stick_area",
        std::numbers::pi * std::pow(scales.contact_radius * theory::stick_radius_ratio(f), 2));
    const double f_cycle = .6, force = *c.load.normal_force;
    expect_target("mindlin_cycle", "shift",
                  scales.unit_shift * theory::static_shift_ratio(f_cycle));
    // The first loading is the half cycle at half its scale (Masing): a quarter of a cycle.
    expect_target("mindlin_cycle", "dissipation",
                  1.25 * theory::cycle_dissipation({c.friction_coefficient(), force,
                                                    c.materials().effective_shear_modulus(),
                                                    scales.contact_radius, f_cycle}));
    expect_target("cylinder_friction", "stick_ratio", std::sqrt(1 - .5));
}

TEST(BenchmarkCatalogue, HasTheNumbersOfFrictionInPressing) {
    const contact::Case c = problem("spence").make_case();
    EXPECT_NEAR(c.materials().dundurs_beta() / c.friction_coefficient(), 1.4, 1e-9);
    expect_target("spence", "stick_ratio", theory::spence_stick_ratio(1.4));
    expect_target("stuck_pressing", "stiffness_ratio", theory::stuck_normal_stiffness_ratio(0));
}

TEST(BenchmarkCatalogue, HasTheNumbersOfRolling) {
    const double f = *problem("carter").make_case().load.tangential_ratio;
    expect_target("carter", "creepage_ratio", theory::carter_creepage_ratio(f));
    expect_target("carter", "stick_ratio", theory::carter_stick_ratio(f));
    expect_target("bentall_johnson", "creepage_ratio", theory::smooth_free_creepage(.5));
    const auto kalker = theory::kalker_coefficients(1, .25);
    expect_target("kalker_coefficients", "c11", kalker.longitudinal);
    expect_target("kalker_coefficients", "c22", kalker.lateral);
    expect_target("kalker_coefficients", "c23", kalker.spin);
    expect_target("kalker_coefficients", "c33", kalker.moment);
    expect_target("shakedown_limit", "shakedown_limit", theory::shakedown_limit(.24));
}

TEST(BenchmarkCatalogue, HasTheNumbersOfLubkin) {
    const contact::Case c = problem("lubkin").make_case();
    const double a = contact::half_space_scales(c).contact_radius, force = 21.1, c_over_a = .5;
    const double friction = c.friction_coefficient() * force;
    EXPECT_NEAR(
        c.prescribed_path->rows.back().rotation /
            (theory::twist_ratio(c_over_a) * friction / (c.substrate.shear_modulus() * a * a)),
        1, 1e-6);
    expect_target("lubkin", "torque", theory::torque_ratio(c_over_a) * friction * a);
    expect_target("lubkin", "stick_area", std::numbers::pi * a * a / 4);
}

TEST(BenchmarkCatalogue, HasTheNumbersOfThePunchAndTheWedge) {
    constexpr double force = 20, radius = 5e-3, modulus = 5.2e6 / (1 - .09), pi = std::numbers::pi;
    expect_target("complete_punch", "indentation", force / (2 * radius * modulus));
    expect_target("complete_punch", "pressure_at_axis", force / (2 * pi * radius * radius));
    expect_target("complete_punch", "pressure_at_0_9",
                  force / (2 * pi * radius * radius * std::sqrt(1 - .81)));
    expect_target("wedge", "force_ratio", (.1 + .3) / (1 - .3 * .1));
}

// Ciavarella, Hills and Monno (1998) at b/a = .5; p a/P by their integral equation.
TEST(BenchmarkCatalogue, HasTheNumbersOfRoundedPunches) {
    constexpr double modulus = 5.2e6 / (1 - .09), a = .01, radius = .1;
    expect_target("rounded_punch", "normal_force", .558933 * modulus * a * a * a / radius);
    expect_target("rounded_punch", "contact_radius", a);
    EXPECT_NEAR(*problem("rounded_punch").make_case().load.indentation, .342427 * a * a / radius,
                1e-12);
    expect_target("rounded_punch_plane", "contact_radius", a);
    expect_target("rounded_punch_plane", "pressure_at_axis",
                  .402918 * .307092 * modulus * a / radius);
}

// Hertz' number is shown beside the hemisphere's, Johnson's (1985, eq. 5.57) is the cylinder's.
TEST(BenchmarkCatalogue, HasTheNumbersOfFiniteBodies) {
    constexpr double modulus = 2e6 / (1 - .09), r = .01, d = 1e-4;
    const auto& targets = problem("hemisphere").targets;
    const auto hertz = std::ranges::find(targets, false, &Target::is_solution);
    ASSERT_NE(hertz, targets.end());
    EXPECT_NEAR(hertz->value, 4. / 3 * modulus * std::sqrt(r) * std::pow(d, 1.5), 1e-6);
    const double load = 43.1537, half = std::sqrt(4 * load * r / (std::numbers::pi * modulus));
    expect_target("cylinder_between_plates", "normal_force", load);
    expect_target("cylinder_between_plates", "contact_radius", half);
    expect_target("cylinder_between_plates", "peak_pressure", 2 * load / (std::numbers::pi * half));
    EXPECT_NEAR(*problem("cylinder_between_plates").make_case().load.indentation,
                load / (std::numbers::pi * modulus) * (2 * std::log(4 * r / half) - 1), 1e-9);
}

/// Hertz' half width and peak pressure of a cylinder on a block [m, Pa].
std::array<double, 2> line_of_hertz(const contact::Case& c) {
    const double load = *c.load.normal_force / c.indenter.length;
    const double half = std::sqrt(4 * load * c.indenter.radius /
                                  (std::numbers::pi * c.materials().effective_modulus()));
    return {half, 2 * load / (std::numbers::pi * half)};
}

TEST(BenchmarkCatalogue, HasTheNumbersOfTwoBodies) {
    for (const char* name : {"nafems_roller", "cattaneo_two_cylinders"}) {
        const auto [half, peak] = line_of_hertz(problem(name).make_case());
        expect_target(name, "contact_radius", half);
        expect_target(name, "peak_pressure", peak);
    }
    expect_target("cattaneo_two_cylinders", "stick_ratio", std::sqrt(1 - .5));
    expect_target("carter_two_cylinders", "creepage_ratio", 1 - std::sqrt(1 - .5));
    // Spence's numbers are those of a rigid punch on nu = .4: beta = (1 - 2 nu)/(2 (1 - nu)).
    EXPECT_NEAR(std::abs(problem("spence_two_bodies").make_case().materials().dundurs_beta()),
                .2 / 1.2, 1e-12);
    const contact::Case two = problem("two_hemispheres").make_case(),
                        one = problem("hemisphere").make_case();
    EXPECT_NEAR(two.indenter.material->young, 2 * 2e6 * 6e6 / (2e6 + 6e6), 1e-6);
    EXPECT_EQ(*two.load.indentation, *one.load.indentation);
    expect_target("two_hemispheres", "normal_force", .31530 * 1.5);
}

}  // namespace
}  // namespace tricontact::benchmark_catalogue_test
