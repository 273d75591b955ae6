#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "bem/settings.h"
#include "contact/cells.h"
#include "contact/relaxing_case.h"
#include "fem/settings.h"
#include "io/case/case_input.h"
#include "io/case/case_reader.h"
#include "io/results/output.h"
#include "mdr/settings.h"

namespace tricontact::io::case_writer_test {
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
    rolling.until = one_of({Case::Until::periods, Case::Until::settled});
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
    const double ratio = between(0.01, 0.5);  // an F_T of 0 has no amplitude
    if (*rc::gen::arbitrary<bool>())
        load.tangential_ratio = ratio;
    else
        load.tangential_force = ratio * mu * force;
    load.press = one_of({Case::Press::friction, Case::Press::frictionless});
    load.press_steps = *rc::gen::inRange(1, 1001);
    load.normal_phase = between(-6, 6);
    load.tangential_phase = between(-6, 6);
    if (oscillating) {  // f (1 + 0.3) / (1 - 0.3) < 1
        load.normal_amplitude_ratio = between(0, 0.3);
        load.tangential_amplitude_ratio = between(0, 0.3);
    }
    return load;
}

contact::Material any_material() {
    return {of_magnitude(3, 10), between(-0.9, 0.5)};
}

// fem: two layers at most, on a rigid ground.
Case::Layer any_layer(double contact_radius, double amplitude, bool fem) {
    Case::Layer layer;
    layer.thickness = between(2, 20) * contact_radius;  // thicker than any indentation
    layer.base = one_of({Case::Base::bonded, Case::Base::frictionless});
    const double patch = 2 * (1.2 * contact_radius + amplitude);  // 1.2: oscillating loads
    if (*rc::gen::arbitrary<bool>()) layer.width = between(1.1, 9) * patch;
    if (*rc::gen::arbitrary<bool>()) layer.depth = between(1.1, 9) * patch;
    for (int n = *rc::gen::inRange(0, fem ? 2 : 5); n > 0; --n)
        layer.lower.push_back({between(0.1, 5) * contact_radius, any_material()});
    if (!fem && *rc::gen::arbitrary<bool>()) {
        layer.base = Case::Base::half_space;
        layer.ground = any_material();
    }
    return layer;
}

fem::Settings any_fem(double contact_radius, bool used) {
    fem::Settings fem;
    const int kind = *rc::gen::inRange(0, used ? 2 : 3);  // a mesh that is used must be there
    if (kind == 0) fem.accuracy = between(1e-4, 0.2);
    if (kind == 1) fem.size = between(0.2, 0.4) * contact_radius;
    if (kind == 2) {
        fem.mesh = "/any" + any_title();
        fem.mesh_unit = of_magnitude(-6, 3);
    }
    fem.growth = between(1.2, 3);
    fem.sides = one_of({fem::Sides::free, fem::Sides::fixed});
    fem.tolerance = of_magnitude(-13, -3);
    fem.cache = one_of<std::string>({"", "none", "/a folder/\"quoted\""});
    return fem;
}

// One of three, with times that differ.
void relax(Case& c) {
    c.relaxation = contact::Relaxation{};
    c.relaxation->bulk =
        one_of({contact::Relaxation::Bulk::proportional, contact::Relaxation::Bulk::elastic});
    const int n = *rc::gen::inRange(1, 6);
    for (int i = 0; i < n; ++i) {
        c.of<io::RelaxationInput>().moduli.push_back(of_magnitude(2, 11));
        c.of<io::RelaxationInput>().times.push_back(of_magnitude(i - 4, i - 3));
        c.relaxation->branches.push_back(
            {c.of<io::RelaxationInput>().moduli.back() / c.substrate.shear_modulus(),
             c.of<io::RelaxationInput>().times.back()});
    }
    c.load.press_time = between(0, 10);
    c.load.hold = between(0, 1000);
    if (c.rolling) c.rolling->speed = of_magnitude(-6, 3);
    if (contact::relaxes_as_one(c)) return;
    std::erase(c.models, "mdr");
    if (c.models.empty()) {
        c.models = {"bem"};
        c.period.reset();
        c.of<bem::Settings>().influence.reset();
    }
    c.of<io::Output>().volume = io::Output::Volume::none;
}

// A case that the reader accepts; scales spread over many decades.
Case any_case() {
    Case c;
    c.title = any_title();
    c.models = one_of<std::vector<std::string>>(
        {{"mdr"}, {"bem"}, {"mdr", "bem"}, {"bem", "mdr"}, {"fem"}, {"mdr", "fem", "bem"}});
    c.indenter.shape = one_of({Case::Shape::paraboloid, Case::Shape::sphere});
    c.indenter.radius = of_magnitude(-4, 2);
    c.substrate = {of_magnitude(3, 10), 0.5};
    const bool fem = std::find(c.models.begin(), c.models.end(), "fem") != c.models.end();
    if (!fem &&
        *rc::gen::arbitrary<bool>())  // the same material twice, or a rigid indenter: beta = 0
        c.indenter.material = c.substrate = {c.substrate.young, between(-0.9, 0.5)};
    c.friction.coefficient = of_magnitude(-2, 1);
    const double d = between(1e-4, 0.1) * c.indenter.radius;
    const double a = std::sqrt(c.indenter.radius * d);
    const double force = 4. / 3 * c.materials().effective_modulus() * a * d;
    if (*rc::gen::arbitrary<bool>()) c.rolling = any_rolling(a);
    const bool oscillating = c.rolling && c.rolling->steps != Case::Steps::turning_points;
    c.load = any_load(c.friction_coefficient(), force, d, oscillating);
    if (*rc::gen::arbitrary<bool>())
        c.of<contact::Cells>().spacing = a * between(0.02, 0.4);
    else
        c.of<contact::Cells>().per_radius = between(2, 50);
    c.of<bem::Settings>().tolerance = of_magnitude(-13, -3);
    c.of<mdr::Settings>().springs = *rc::gen::inRange(100, 5000);
    c.of<mdr::Settings>().elements_per_radius = *rc::gen::inRange(5, 1000);
    c.of<io::Output>().vtk = one_of({io::Output::Vtk::none, io::Output::Vtk::quarters,
                                     io::Output::Vtk::frames, io::Output::Vtk::all});
    if (c.of<io::Output>().vtk == io::Output::Vtk::frames)
        c.of<io::Output>().frames_per_period = *rc::gen::inRange(4, 10001);
    c.of<io::Output>().volume =
        one_of({io::Output::Volume::none, io::Output::Volume::last, io::Output::Volume::quarters});
    if (*rc::gen::arbitrary<bool>()) c.of<bem::Settings>().volume_depth = between(.1, 10) * a;
    const double w = c.rolling ? contact::rolling_amplitude(*c.rolling, a) : 0;
    if (fem || *rc::gen::arbitrary<bool>()) c.layer = any_layer(a, w, fem);
    const bool bem = std::find(c.models.begin(), c.models.end(), "bem") != c.models.end();
    if (!bem && c.layer.thickness) c.period = between(1, 100) * a;  // kept, but not used
    if (!bem) c.of<bem::Settings>().influence = "/any" + any_title();
    if (c.models == std::vector<std::string>{"fem"}) c.substrate.poisson = between(-0.9, 0.5);
    const bool between_turning_points =
        c.rolling && c.rolling->steps == Case::Steps::turning_points;
    if (!between_turning_points && *rc::gen::arbitrary<bool>()) relax(c);
    c.contact = {.coupling = *rc::gen::arbitrary<bool>()};
    c.of<fem::Settings>() = any_fem(a, fem);
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
    same(a.limit_fraction, b.limit_fraction);
    same(a.limit_excess, b.limit_excess);
    same(a.normal_amplitude_ratio, b.normal_amplitude_ratio);
    same(a.normal_phase, b.normal_phase);
    same(a.tangential_amplitude_ratio, b.tangential_amplitude_ratio);
    same(a.tangential_phase, b.tangential_phase);
    RC_ASSERT(a.press == b.press);
    RC_ASSERT(a.press_steps == b.press_steps);
    same(a.press_time, b.press_time);
    same(a.hold, b.hold);
}

void same(const Case::Layer& a, const Case::Layer& b) {
    same(a.thickness, b.thickness);
    RC_ASSERT(a.base == b.base);
    same(a.width, b.width);
    same(a.depth, b.depth);
    RC_ASSERT(a.lower.size() == b.lower.size());
    for (std::size_t i = 0; i < a.lower.size(); ++i) {
        same(a.lower[i].thickness, b.lower[i].thickness);
        same(a.lower[i].material, b.lower[i].material);
    }
    RC_ASSERT(a.ground.has_value() == b.ground.has_value());
    if (a.ground) same(*a.ground, *b.ground);
}

void same(const fem::Settings& a, const fem::Settings& b) {
    same(a.size, b.size);
    same(a.accuracy, b.accuracy);
    same(a.growth, b.growth);
    RC_ASSERT(a.sides == b.sides);
    same(a.tolerance, b.tolerance);
    RC_ASSERT(a.mesh == b.mesh);
    same(a.mesh_unit, b.mesh_unit);
    RC_ASSERT(a.cache == b.cache);
}

void same(const Case::Rolling& a, const Case::Rolling& b) {
    same(a.amplitude, b.amplitude);
    same(a.amplitude_ratio, b.amplitude_ratio);
    RC_ASSERT(a.amplitude_reference == b.amplitude_reference);
    same(a.angle, b.angle);
    RC_ASSERT(a.periods == b.periods && a.until == b.until && a.run_all == b.run_all);
    RC_ASSERT(a.steps == b.steps);
    same(a.increment, b.increment);
    RC_ASSERT(a.steps_per_quarter == b.steps_per_quarter);
    same(a.speed, b.speed);
}

void same(const std::optional<contact::Relaxation>& a,
          const std::optional<contact::Relaxation>& b) {
    RC_ASSERT(a.has_value() == b.has_value());
    if (!a) return;
    RC_ASSERT(a->bulk == b->bulk);
    RC_ASSERT(a->branches.size() == b->branches.size());
    for (std::size_t i = 0; i < a->branches.size(); ++i) {
        same(a->branches[i].ratio, b->branches[i].ratio);
        same(a->branches[i].time, b->branches[i].time);
    }
}

void same(const Case& a, const Case& b) {
    RC_ASSERT(a.title == b.title);
    RC_ASSERT(a.models == b.models);
    RC_ASSERT(a.indenter.shape == b.indenter.shape);
    same(a.indenter.radius, b.indenter.radius);
    RC_ASSERT(a.indenter.material.has_value() == b.indenter.material.has_value());
    if (a.indenter.material) same(*a.indenter.material, *b.indenter.material);
    same(a.substrate, b.substrate);
    same(a.relaxation, b.relaxation);
    same(a.friction_coefficient(), b.friction_coefficient());
    same(a.load, b.load);
    RC_ASSERT(a.rolling.has_value() == b.rolling.has_value());
    if (a.rolling) same(*a.rolling, *b.rolling);
    same(a.of<contact::Cells>().spacing, b.of<contact::Cells>().spacing);
    same(a.of<contact::Cells>().per_radius, b.of<contact::Cells>().per_radius);
    same(a.of<bem::Settings>().tolerance, b.of<bem::Settings>().tolerance);
    same(a.period, b.period);
    RC_ASSERT(a.of<bem::Settings>().influence == b.of<bem::Settings>().influence);
    RC_ASSERT(a.of<mdr::Settings>().springs == b.of<mdr::Settings>().springs);
    RC_ASSERT(a.of<mdr::Settings>().elements_per_radius ==
              b.of<mdr::Settings>().elements_per_radius);
    same(a.layer, b.layer);
    RC_ASSERT(a.contact.coupling == b.contact.coupling);
    same(a.of<fem::Settings>(), b.of<fem::Settings>());
    RC_ASSERT(a.of<io::Output>().vtk == b.of<io::Output>().vtk);
    RC_ASSERT(a.of<io::Output>().volume == b.of<io::Output>().volume);
    same(a.of<bem::Settings>().volume_depth, b.of<bem::Settings>().volume_depth);
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

}  // namespace
}  // namespace tricontact::io::case_writer_test
