#include "benchmarks/reference/reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "benchmarks/reference/radial_contact.h"
#include "tests/unit/benchmarks/reference_cases.h"
#include "theory/hertz.h"

namespace tricontact::benchmarks::reference_test {
namespace {

using contact::Case;
using contact::NormalControl;
using reference_cases::expect_refused;
using reference_cases::expect_within_bar;
using reference_cases::foreign_case;
using reference_cases::half_space_case;
using reference_cases::hertz;
using reference_cases::of;
using std::numbers::pi;
namespace keys = quantity_keys;

constexpr double megapascal_per_mm = 1e9;

/// The layer pressed to .35 mm without friction, computed once.
const Reference& pressed_layer() {
    static const Reference layer = of(foreign_case("layer_pressed"));
    return layer;
}
const Reference& incompressible_layer() {
    static const Reference layer = of(foreign_case("layer_pressed", {"substrate.poisson=0.4999"}));
    return layer;
}

const Reference& hertz_contact() {
    static const Reference contact = of(half_space_case(hertz));
    return contact;
}

// F, a and p0 of the layer by an independent solution of the Fredholm equation, to the digits that
// were printed.
TEST(BenchmarkReference, LayerHasIndependentNumbers) {
    const Reference& layer = pressed_layer();
    EXPECT_NEAR(layer.find(keys::normal_force)->value, 16.48962, 5e-6);
    EXPECT_NEAR(layer.find(keys::contact_radius)->value, 4.33400e-3, 5e-9);
    EXPECT_NEAR(layer.find(keys::peak_pressure)->value, .421046e6, .5);
    EXPECT_EQ(layer.geometry, Geometry::axisymmetric);
    EXPECT_FALSE(layer.has_friction());
    EXPECT_EQ(layer.prescribed, std::vector<std::string>{keys::indentation});
    // The models that are exact for the case agree to 1e-4.
    EXPECT_EQ(layer.models.size(), 3u);
    EXPECT_LT(layer.find(keys::normal_force)->bar(), 1e-4 * 16.5);
    EXPECT_GT(layer.find(keys::normal_force)->bar(), 0);
    EXPECT_EQ(layer.find(keys::indentation)->bar(), 0);
}

TEST(BenchmarkReference, IncompressibleLayerHasIndependentNumbers) {
    const Case c = foreign_case("layer_pressed", {"substrate.poisson=0.4999"});
    const RadialContact layer(c, {NormalControl::Kind::indentation, .35e-3});
    EXPECT_NEAR(layer.force(), 24.609, 5e-4);
    EXPECT_NEAR(layer.radius(), 4.5761e-3, 5e-8);
    EXPECT_NEAR(layer.pressure(0), .56617e6, 5);
}

TEST(BenchmarkReference, FieldsOfTheLayerBalance) {
    const Reference& layer = pressed_layer();
    const double a = layer.contact_radius, force = layer.find(keys::normal_force)->value;
    // ∫ p dA, r = a sin(theta), by the midpoint rule.
    const auto load = [&](double radius) {
        constexpr int n = 2000;
        const double end = std::asin(radius / a);
        double sum = 0;
        for (int i = 0; i < n; ++i) {
            const double theta = (i + .5) * end / n, r = a * std::sin(theta);
            sum += layer.fields->at(0, r).pressure * r * a * std::cos(theta) * end / n;
        }
        return 2 * pi * sum;
    };
    for (const double radius : {.3 * a, .7 * a, a})
        EXPECT_NEAR(layer.fields->load_within(radius), load(radius), 1e-6 * force);
    EXPECT_NEAR(layer.fields->load_within(2 * a), force, 1e-9 * force);
    // Rigid: u_z = d - h, and no jump at the edge; nothing presses beyond.
    EXPECT_NEAR(layer.fields->at(.5 * a, 0).displacement_z, .35e-3 - .125 * a * a / .04, 1e-12);
    EXPECT_NEAR(layer.fields->at(.999999 * a, 0).displacement_z,
                layer.fields->at(1.000001 * a, 0).displacement_z, 1e-9);
    EXPECT_EQ(layer.fields->at(1.01 * a, 0).pressure, 0);
    EXPECT_TRUE(std::isnan(layer.fields->at(50 * a, 0).displacement_z));
    // Turned with the point.
    const SurfaceValues turned = layer.fields->at(.3 * a, .4 * a);
    EXPECT_NEAR(std::hypot(turned.displacement_x, turned.displacement_y),
                std::abs(layer.fields->at(.5 * a, 0).displacement_x), 1e-15);
    EXPECT_LT(turned.displacement_x, 0);
}

// Outside of its contact the layer's surface rises or sinks; far away it is at rest, and an
// incompressible layer keeps its volume: ∫ u_z dA = 0.
TEST(BenchmarkReference, IncompressibleLayerKeepsItsVolume) {
    const Case c = foreign_case("layer_pressed", {"substrate.poisson=0.5"});
    const RadialContact layer(c, {NormalControl::Kind::indentation, .35e-3});
    constexpr int n = 4000;
    const double end = 19 * layer.radius();
    double volume = 0, moved = 0;
    for (int i = 0; i < n; ++i) {
        const double r = (i + .5) * end / n;
        const double part = layer.normal_displacement(r) * r;
        volume += part;
        moved += std::abs(part);
    }
    // What lies beyond has decayed by exp(-0.739 r/b) = 3e-4.
    EXPECT_NEAR(volume / moved, 0, 1e-3);
}

TEST(BenchmarkReference, HalfSpaceIsHertz) {
    const Case c = half_space_case(hertz);
    const Reference& r = hertz_contact();
    const auto scales = contact::half_space_scales(c);
    EXPECT_EQ(r.find(keys::normal_force)->source, "Hertz (1882)");
    expect_within_bar(r, keys::normal_force, scales.normal_force);
    expect_within_bar(r, keys::contact_radius, .1);
    expect_within_bar(r, keys::peak_pressure, scales.peak_pressure);
    // 2/5 F d.
    expect_within_bar(r, keys::stored_energy, .4 * scales.normal_force * .01);
    for (const double share : {0., .3, .8, .99}) {
        const double x = share * .1;
        EXPECT_NEAR(r.fields->at(x, 0).pressure, theory::hertz_pressure(scales, x),
                    1e-7 * scales.peak_pressure);
    }
    for (const double x : {.05, .15, .4})
        EXPECT_NEAR(r.fields->at(x, 0).displacement_z,
                    theory::hertz_surface_displacement(scales, x), 1e-8);
    // Johnson (1985), eq. 3.41c: -(1 - 2 nu)(1 + nu)/(3 E) a^2/r p0 [1 - (1 - r^2/a^2)^(3/2)].
    const double r_half = .05;
    const double u =
        -.4 * 1.3 / (3 * 15e6) * .01 / r_half * scales.peak_pressure * (1 - std::pow(.75, 1.5));
    EXPECT_NEAR(r.fields->at(r_half, 0).displacement_x, u, 1e-6 * std::abs(u));
}

// ∫ p^2 dA = pi/2 p0^2 a^2 of Hertz, p0 = 2 E* sqrt(d/R)/pi, a^2 = R d: -1/2 d/dd is -2/pi E*^2 d.
TEST(BenchmarkReference, PenaltyOnHertzHasAClosedForm) {
    const Reference& r = hertz_contact();
    const double modulus = 15e6 / .91;
    const double exact = -2 / pi * modulus * modulus * .01;
    EXPECT_NEAR(r.effects.normal_compliance->value, exact, 1e-6 * std::abs(exact));
}

/// Change of F over F.
double relative(const Reference& reference, const std::optional<ReferenceValue>& effect,
                double by) {
    return effect->value * by / reference.find(keys::normal_force)->value;
}

// Predictions that runs of CalculiX, FreeFem++ and GetFEM were compared with, and those runs.
TEST(BenchmarkReference, EffectsOnTheLayerAreThoseThatWereMeasured) {
    const Reference& layer = pressed_layer();
    const auto penalty = [&](double stiffness) {
        return relative(layer, layer.effects.normal_compliance,
                        1 / (stiffness * megapascal_per_mm));
    };
    EXPECT_NEAR(penalty(26), -.0420, .0005);
    EXPECT_NEAR(penalty(260), -.00420, .00005);
    EXPECT_NEAR(penalty(2600), -.000420, .000005);
    EXPECT_NEAR(penalty(26), -.0403, .1 * .0403);     // FreeFem++ P2
    EXPECT_NEAR(penalty(260), -.00401, .1 * .00401);  // the same
    EXPECT_NEAR(penalty(260), -.0041, .1 * .0041);    // CalculiX, against 2600
    const double displaced = relative(layer, layer.effects.displaced_surface, 1);
    EXPECT_NEAR(displaced, .0220, .0001);
    EXPECT_NEAR(displaced, .0184, .2 * .0184);  // GetFEM Q2
    const double bar = layer.effects.displaced_surface->bar() / 16.49;
    EXPECT_NEAR(displaced, .0184, bar);
}

TEST(BenchmarkReference, DisplacedSurfaceIsThatOfGetfemAtASmallDepthAndWithoutCompression) {
    const auto shallow = of(foreign_case("layer_pressed", {"load.indentation=0.05 mm"}));
    EXPECT_NEAR(relative(shallow, shallow.effects.displaced_surface, 1), .00768, .00005);
    EXPECT_NEAR(relative(shallow, shallow.effects.displaced_surface, 1), .00735, .2 * .00735);
    const Reference& incompressible = incompressible_layer();
    EXPECT_NEAR(relative(incompressible, incompressible.effects.displaced_surface, 1), -.0199,
                .0001);
    EXPECT_NEAR(relative(incompressible, incompressible.effects.displaced_surface, 1), -.0245,
                .25 * .0245);
}

// Under a force the same compliance appears in the depth: dd = -dF/(dF/dd).
TEST(BenchmarkReference, ForceAndDepthControlAgreeInTheirEffects) {
    const Reference& depth = pressed_layer();
    const Reference force = of(foreign_case("layer_pressed", {"load.normal_force=16.48962 N"}));
    EXPECT_TRUE(force.is_prescribed(keys::normal_force));
    EXPECT_NEAR(force.find(keys::indentation)->value, .35e-3, 1e-10);
    const double stiffness = depth.find(keys::normal_stiffness)->value;
    EXPECT_NEAR(force.effects.normal_compliance->value,
                -depth.effects.normal_compliance->value / stiffness,
                1e-4 * force.effects.normal_compliance->value);
    EXPECT_NEAR(force.effects.displaced_surface->value,
                -depth.effects.displaced_surface->value / stiffness,
                1e-4 * std::abs(force.effects.displaced_surface->value));
}

TEST(BenchmarkReference, SidesOfABlockAddToItsCompliance) {
    const Reference& layer = incompressible_layer();
    const auto near = finite_block_effect(layer, 26e-3), far = finite_block_effect(layer, 48e-3);
    const ReferenceValue change = near.at(keys::normal_force);
    EXPECT_LT(change.value, 0);
    EXPECT_LE(change.value + change.bar(), 0);
    EXPECT_LT(std::abs(far.at(keys::normal_force).value), .1 * std::abs(change.value));
    // The case's own sides end in the bar of the domain.
    const Reference block =
        of(foreign_case("layer_pressed", {"substrate.poisson=0.4999", "substrate.width=52 mm",
                                          "substrate.depth=52 mm"}));
    EXPECT_GT(block.find(keys::normal_force)->domain, 0);
    EXPECT_NEAR(block.find(keys::normal_force)->domain, -2 * change.value, .5 * -change.value);
    EXPECT_FALSE(block.remarks.empty());
}

TEST(BenchmarkReference, RefusesWhatNoModelIsAReferenceFor) {
    expect_refused(
        foreign_case("layer_pressed", {"models=[\"fem\"]", "substrate.material=neo-hookean",
                                       "contact.coupling=true"}),
        "small strains");
    Case rough = half_space_case(hertz);
    rough.indenter.roughness = contact::Roughness{};
    expect_refused(rough, "smooth");
    Case relaxing = half_space_case(hertz);
    relaxing.relaxation.emplace();
    expect_refused(relaxing, "elastic substrate");
}

}  // namespace
}  // namespace tricontact::benchmarks::reference_test
