#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "io/case_reader.h"
#include "io/case_writer.h"

namespace tricontact::io {
namespace {

using contact::Case;

// A double in [low, high] with all bits of its mantissa in play.
double between(double low, double high) {
    const auto bits = *rc::gen::arbitrary<std::uint64_t>();
    return low + (high - low) * (static_cast<double>(bits >> 11) * 0x1p-53);
}

double of_magnitude(int low, int high) {
    return std::pow(10., between(low, high));
}

template <class T>
T one_of(std::initializer_list<T> values) {
    return *rc::gen::elementOf(std::vector<T>(values));
}

// Printable ASCII, quotes, backslashes, control characters and letters of several bytes.
std::string any_title() {
    const auto pieces = *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(
        std::vector<std::string>{"a", " ", "\"", "\\", "\n", "\t", "\r", "\x01", "\x7f", "#", "=",
                                 "\u00e4", "\u20ac", "\U0001d70f", "[x]", "\\u0041"}));
    std::string title;
    for (const auto& piece : pieces) title += piece;
    return title;
}

Case::Rolling any_rolling(double contact_radius) {
    Case::Rolling rolling;
    if (*rc::gen::arbitrary<bool>()) {
        rolling.amplitude = between(0, 2) * contact_radius;
    } else {
        rolling.amplitude_ratio = between(0, 2);
        rolling.amplitude_reference =
            one_of({Case::AmplitudeReference::hertz, Case::AmplitudeReference::model});
    }
    rolling.angle = between(-2 * std::numbers::pi, 2 * std::numbers::pi);
    rolling.periods = *rc::gen::inRange(1, 50);
    rolling.run_all = *rc::gen::arbitrary<bool>();
    rolling.steps =
        one_of({Case::Steps::increment, Case::Steps::per_quarter, Case::Steps::turning_points});
    if (rolling.steps == Case::Steps::increment)
        rolling.increment = between(0.01, 1) * contact_radius;
    if (rolling.steps == Case::Steps::per_quarter)
        rolling.steps_per_quarter = *rc::gen::inRange(1, 60);
    return rolling;
}

Case::Load any_load(double mu, double force, double indentation, bool oscillating) {
    Case::Load load;
    const bool by_force = *rc::gen::arbitrary<bool>();
    if (by_force)
        load.normal_force = force;
    else
        load.indentation = indentation;
    const double ratio = between(0, 0.5);
    if (*rc::gen::arbitrary<bool>())
        load.tangential_ratio = ratio;
    else
        load.tangential_force = ratio * mu * force;
    load.normal_phase = between(-6, 6);
    load.tangential_phase = between(-6, 6);
    if (oscillating) {  // f (1 + 0.3) / (1 - 0.3) < 1
        load.normal_amplitude_ratio = between(0, 0.3);
        load.tangential_amplitude_ratio = between(0, 0.3);
    }
    return load;
}

// A case that the reader accepts; scales spread over many decades.
Case any_case() {
    Case c;
    c.title = any_title();
    c.models = one_of<std::vector<std::string>>({{"mdr"}, {"bem"}, {"mdr", "bem"}, {"bem", "mdr"}});
    c.indenter.shape = one_of({Case::Shape::paraboloid, Case::Shape::sphere});
    c.indenter.radius = of_magnitude(-4, 2);
    c.substrate = {of_magnitude(3, 10), 0.5};
    if (*rc::gen::arbitrary<bool>())  // the same material twice, or a rigid indenter: beta = 0
        c.indenter.material = c.substrate = {c.substrate.young, between(-0.9, 0.5)};
    c.friction_coefficient = of_magnitude(-2, 1);
    const double d = between(1e-4, 0.1) * c.indenter.radius;
    const double a = std::sqrt(c.indenter.radius * d);
    const double force = 4. / 3 * c.materials().effective_modulus() * a * d;
    if (*rc::gen::arbitrary<bool>()) c.rolling = any_rolling(a);
    const bool oscillating = c.rolling && c.rolling->steps != Case::Steps::turning_points;
    c.load = any_load(c.friction_coefficient, force, d, oscillating);
    if (*rc::gen::arbitrary<bool>())
        c.bem.spacing = a * between(0.02, 0.4);
    else
        c.bem.cells_per_radius = between(2, 50);
    c.bem.tolerance = of_magnitude(-13, -3);
    c.mdr.springs = *rc::gen::inRange(100, 5000);
    c.output.vtk = one_of({Case::VtkOutput::none, Case::VtkOutput::quarters, Case::VtkOutput::all});
    return c;
}

void same(double a, double b) {
    RC_ASSERT(std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b));
}
void same(const std::optional<double>& a, const std::optional<double>& b) {
    RC_ASSERT(a.has_value() == b.has_value());
    if (a) same(*a, *b);
}

void same(const contact::Material& a, const contact::Material& b) {
    same(a.young, b.young);
    same(a.poisson, b.poisson);
}

void same(const Case::Load& a, const Case::Load& b) {
    same(a.normal_force, b.normal_force);
    same(a.indentation, b.indentation);
    same(a.tangential_force, b.tangential_force);
    same(a.tangential_ratio, b.tangential_ratio);
    same(a.normal_amplitude_ratio, b.normal_amplitude_ratio);
    same(a.normal_phase, b.normal_phase);
    same(a.tangential_amplitude_ratio, b.tangential_amplitude_ratio);
    same(a.tangential_phase, b.tangential_phase);
}

void same(const Case::Rolling& a, const Case::Rolling& b) {
    same(a.amplitude, b.amplitude);
    same(a.amplitude_ratio, b.amplitude_ratio);
    RC_ASSERT(a.amplitude_reference == b.amplitude_reference);
    same(a.angle, b.angle);
    RC_ASSERT(a.periods == b.periods);
    RC_ASSERT(a.run_all == b.run_all);
    RC_ASSERT(a.steps == b.steps);
    same(a.increment, b.increment);
    RC_ASSERT(a.steps_per_quarter == b.steps_per_quarter);
}

void same(const Case& a, const Case& b) {
    RC_ASSERT(a.title == b.title);
    RC_ASSERT(a.models == b.models);
    RC_ASSERT(a.indenter.shape == b.indenter.shape);
    same(a.indenter.radius, b.indenter.radius);
    RC_ASSERT(a.indenter.material.has_value() == b.indenter.material.has_value());
    if (a.indenter.material) same(*a.indenter.material, *b.indenter.material);
    same(a.substrate, b.substrate);
    same(a.friction_coefficient, b.friction_coefficient);
    same(a.load, b.load);
    RC_ASSERT(a.rolling.has_value() == b.rolling.has_value());
    if (a.rolling) same(*a.rolling, *b.rolling);
    same(a.bem.spacing, b.bem.spacing);
    same(a.bem.cells_per_radius, b.bem.cells_per_radius);
    same(a.bem.tolerance, b.bem.tolerance);
    RC_ASSERT(a.mdr.springs == b.mdr.springs);
    RC_ASSERT(a.output.vtk == b.output.vtk);
}

TEST(CaseWriter, ReadingBackGivesTheSameBits) {
    const bool holds = rc::check([] {
        const Case c = any_case();
        const std::string text = write_case(c);
        const Case back = parse_case(text, "resolved.toml");
        same(c, back);
        RC_ASSERT(write_case(back) == text);
    });
    EXPECT_TRUE(holds);
}

TEST(CaseWriter, WritesEveryDefaultInSiUnits) {
    const std::string input = R"(models = ["mdr"]
[indenter]
radius = "40 mm"
[substrate]
young = "5.2 MPa"
poisson = 0.5
[friction]
coefficient = 0.57
[load]
indentation = "0.5 mm"
tangential_ratio = 0.5
[rolling]
amplitude_ratio = 0.25
angle = "90 deg"
)";
    const std::string resolved = R"(title = ""
models = ["mdr"]

[indenter]
shape = "paraboloid"
radius = "0.04 m"

[substrate]
young = "5200000 Pa"
poisson = 0.5

[friction]
coefficient = 0.57

[load]
indentation = "5e-04 m"
tangential_ratio = 0.5
normal_amplitude_ratio = 0.0
normal_phase = "0 rad"
tangential_amplitude_ratio = 0.0
tangential_phase = "0 rad"

[rolling]
amplitude_ratio = 0.25
amplitude_reference = "hertz"
angle = "1.5707963267948966 rad"
periods = 12
run_all = false
steps_per_quarter = 6

[bem]
cells_per_radius = 22.5
tolerance = 1e-07

[mdr]
springs = 10000

[output]
vtk = "quarters"
)";
    EXPECT_EQ(write_case(parse_case(input, "case.toml")), resolved);
}

}  // namespace
}  // namespace tricontact::io
