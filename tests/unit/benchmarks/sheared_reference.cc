#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "benchmarks/reference/plane_contact.h"
#include "tests/unit/benchmarks/reference_cases.h"

// References of plane contacts, and of those that carry tangential loads.
namespace tricontact::benchmarks::sheared_reference_test {
namespace {

using contact::Case;
using contact::NormalControl;
using reference_cases::expect_refused;
using reference_cases::expect_within_bar;
using reference_cases::half_space_case;
using reference_cases::hertz;
using reference_cases::of;
using std::numbers::pi;
namespace keys = quantity_keys;

const std::string cylinder = R"(
[indenter]
shape = "cylinder"
radius = "50 mm"
length = "1 m"
young = "210 GPa"
poisson = 0.3
[substrate]
young = "70 GPa"
poisson = 0.3
[friction]
coefficient = 0.1
[contact]
coupling = false
[load]
normal_force = "35 MN"
)";

// NAFEMS CB1: a = 6.21 mm, p0 = 3585.37 MPa (SSNP154 of code_aster).
TEST(ShearedReference, CylinderOnABlockIsNafemsCb1) {
    Case c = half_space_case(cylinder + "tangential_ratio = 0\n");
    const Reference r = of(c);
    EXPECT_EQ(r.geometry, Geometry::plane);
    EXPECT_NEAR(r.find(keys::contact_radius)->value, 6.21e-3, 1e-5);
    EXPECT_NEAR(r.find(keys::peak_pressure)->value, 3585.37e6, .1e6);
    EXPECT_NEAR(r.find(keys::normal_force)->value, 35e6, 1);
    EXPECT_EQ(r.find(keys::indentation), nullptr);
    EXPECT_NEAR(r.fields->load_within(1), 35e6, 1);
    // p does not depend on y.
    EXPECT_EQ(r.fields->at(1e-3, 0).pressure, r.fields->at(-1e-3, 5e-3).pressure);
}

// Cattaneo (1938): what sticks is 2 c = 2 a sqrt(1 - f); tau in it is mu p less mu p0 c/a
// sqrt(1 - x^2/c^2).
TEST(ShearedReference, ShearedCylinderIsCattaneo) {
    const Reference r = of(half_space_case(cylinder + "tangential_ratio = 0.5\n"));
    const double a = r.contact_radius, c = a * std::sqrt(.5);
    expect_within_bar(r, keys::stick_area, 2 * c);
    EXPECT_TRUE(r.has_friction());
    const double p0 = r.find(keys::peak_pressure)->value;
    for (const double share : {0., .3, .5, .85}) {
        const double x = share * a;
        const double stick = x < c ? c / a * std::sqrt(1 - x * x / (c * c)) : 0;
        const double exact = .1 * p0 * (std::sqrt(1 - share * share) - stick);
        // Of cells, linear between them: 1 % at 64 in the half width.
        EXPECT_NEAR(r.fields->at(x, 0).traction_x, exact, .01 * .1 * p0) << share;
    }
    EXPECT_TRUE(r.effects.tangential_compliance);
}

// Johnson (1985), section 7.2d, at nu = 0: exact.
TEST(ShearedReference, ShearedSphereIsCattaneoAndMindlin) {
    const Case c = half_space_case(hertz, {"substrate.poisson=0", "load.tangential_ratio=0.5"});
    const Reference r = of(c);
    const double a = .1, stick = a * std::cbrt(.5);
    EXPECT_NEAR(r.find(keys::stick_area)->value, pi * stick * stick, 1e-9);
    EXPECT_NEAR(r.find(keys::shift)->value, .3 * .01 * (1 - std::pow(.5, 2. / 3)), 1e-9);
    EXPECT_LT(r.find(keys::shift)->bar(), 1e-4 * r.find(keys::shift)->value);
    EXPECT_EQ(r.geometry, Geometry::spatial);
}

// Carter (1926), Johnson (1985), eq. 8.46 and 8.48: xi R/(mu a) = 1 - sqrt(1 - f), c/a = sqrt(1 -
// f); the tractions carry f mu F_N.
TEST(ShearedReference, RollingCylinderIsCarter) {
    const std::string free_of_coupling = R"(
[tractive_rolling]
distance = 6
)";
    const Case c = io::parse_case(
        "models = [\"bem\"]\n" + cylinder + "tangential_ratio = 0.56\n" + free_of_coupling,
        "case.toml", {"load.normal_force=2110 N", "indenter.length=8 m", "substrate.young=5 MPa"});
    const Reference r = of(c);
    const double a = r.contact_radius, load = 2110. / 8;
    EXPECT_NEAR(r.find(keys::creepage)->value, .336675 * .1 * a / .05, 1e-6 * .1 * a / .05);
    EXPECT_NEAR(r.find(keys::stick_area)->value, .663325 * 2 * a, 1e-6 * a);
    EXPECT_NEAR(r.find(keys::tangential_force)->value, .056 * load, 1e-9 * load);
    double sum = 0;
    constexpr int n = 4000;
    for (int i = 0; i < n; ++i)
        sum += r.fields->at(-a + (i + .5) * 2 * a / n, 0).traction_x * 2 * a / n;
    EXPECT_NEAR(sum, .056 * load, 1e-4 * .056 * load);
    EXPECT_TRUE(r.is_prescribed(keys::tangential_force));
    Case sphere = half_space_case(hertz);
    sphere.tractive_rolling.emplace();
    expect_refused(sphere, "rolls on");
}

// Lubkin (1951): the numbers of the catalogue, c = a/2.
TEST(ShearedReference, TwistedSphereIsLubkin) {
    const Reference r = of(half_space_case(R"(
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.3
[friction]
coefficient = 0.57
[contact]
coupling = false
[path]
steps = 10
table = """
normal_force [N], rotation [mrad]
21.1, 0
21.1, 58.84648389
"""
)"));
    EXPECT_EQ(r.find(keys::torque)->source, "Lubkin (1951)");
    EXPECT_NEAR(r.find(keys::torque)->value, 30.53130e-3, 1e-8);
    EXPECT_NEAR(r.find(keys::stick_area)->value, 18.11553e-6, 1e-10);
    EXPECT_LT(r.find(keys::torque)->model, 1e-4 * 30.5e-3);  // bem
}

// Plane: the sum of p over the layer's contact is its load, and its surface is drawn inwards.
TEST(ShearedReference, PlaneLayerBalances) {
    const Case c = io::parse_case("models = [\"bem-layer\"]\n" + cylinder, "case.toml",
                                  {"substrate.thickness=20 mm", "substrate.young=5 MPa",
                                   "load.indentation=0.3 mm", "load.tangential_ratio=0"});
    const PlaneContact layer(c, {NormalControl::Kind::indentation, .3e-3});
    double sum = 0;
    constexpr int n = 2000;
    for (int i = 0; i < n; ++i) {
        const double theta = (i + .5) * pi / 2 / n;
        const double x = layer.half_width() * std::sin(theta);
        sum += 2 * layer.pressure(x) * layer.half_width() * std::cos(theta) * pi / 2 / n;
    }
    EXPECT_NEAR(sum, layer.load(), 1e-6 * layer.load());
    EXPECT_NEAR(layer.load_within(layer.half_width()), layer.load(), 1e-9 * layer.load());
    EXPECT_LT(layer.displacement_along(layer.half_width()), 0);
}

}  // namespace
}  // namespace tricontact::benchmarks::sheared_reference_test
