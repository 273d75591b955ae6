#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "benchmarks/reference/exact_parts.h"
#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/reference_kinds.h"
#include "comparisons/resolution/refinement.h"
#include "contact/base/error.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"

// Pressing of bodies of a finite size: finite elements of their section on three meshes, 12, 24 and
// 48 elements across the contact's half width.

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
using std::numbers::pi;
namespace keys = quantity_keys;

constexpr std::array elements_of_levels{12., 24., 48.};
constexpr std::array elements_with_friction{8., 16., 32.};  // a path takes many steps on each
constexpr std::array elements_that_roll{3., 6., 12.};       // a step a node
constexpr double least_rolled = 6;  // of each leg, in a: the force has built up after 4 a
constexpr double measured_end = 1;  // of each leg, in a: where creep is measured
constexpr double elements_of_neighbours = 32;
constexpr double neighbour_step = .06;  // of depth or force, in effects

/// Elements of this size, whose growth over a length is that of the case at 12 in the radius.
Case on_elements(Case c, double radius, double count) {
    auto& settings = c.of<fem::Settings>();
    settings.size = radius / count;
    settings.growth = 1 + (settings.growth - 1) * elements_of_levels.front() / count;
    return c;
}

/// Pressure over the distance from the middle. Between nodes its square is linear: smooth inside,
/// and of the right power at the edge.
class PressureProfile {
  public:
    PressureProfile(const EndState& end, double radius, bool is_plane)
        : radius_(radius), is_plane_(is_plane) {
        const contact::Surface& s = end.surface;
        const int row = (s.n_y - 1) / 2;
        const double nearest = -1e-9 * s.spacing[0];
        for (int i = 0; i < s.n_x; ++i) {
            const double r = s.x(i) - s.offset[0];
            if (r < nearest || r >= radius) continue;
            const double p = s.normal_traction[static_cast<std::size_t>(row) * s.n_x + i];
            r_.push_back(r);
            squares_.push_back(p * p);
        }
        r_.push_back(radius);
        squares_.push_back(0);
    }

    double pressure(double r) const {
        if (r >= radius_) return 0;
        const auto above = std::ranges::upper_bound(r_, r);
        const auto i = std::clamp<std::ptrdiff_t>(above - r_.begin(), 1, std::ssize(r_) - 1);
        const double share = (r - r_[i - 1]) / (r_[i] - r_[i - 1]);
        return std::sqrt(std::max(0., squares_[i - 1] + share * (squares_[i] - squares_[i - 1])));
    }

    /// ∫ p^power dA over the distance r, of plane contacts over |x| < r.
    double integral(double r, int power) const {
        constexpr int n = 400;  // even; over theta, r = a sin(theta)
        const double end = std::asin(std::min(1., r / radius_));
        double sum = 0;
        for (int i = 0; i <= n; ++i) {
            const double theta = end * i / n, x = radius_ * std::sin(theta);
            const double weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
            sum += weight * std::pow(pressure(x), power) * (is_plane_ ? 2 : 2 * pi * x) * radius_ *
                   std::cos(theta);
        }
        return sum * end / (3 * n);
    }

  private:
    double radius_;
    bool is_plane_;
    std::vector<double> r_, squares_;
};

std::shared_ptr<const RadialFields> section_fields(const Reference& reference,
                                                   const EndState& finest) {
    const bool is_plane = reference.geometry == Geometry::plane;
    const double a = reference.contact_radius, force = reference.find(keys::normal_force)->value,
                 unknown = std::nan("");
    const PressureProfile profile(finest, a, is_plane);
    const double share = force / profile.integral(a, 1);
    const RadialFields::Bars bars{.pressure = relative_bar(reference, keys::peak_pressure),
                                  .radius = relative_bar(reference, keys::contact_radius),
                                  .displacement = 0};
    return std::make_shared<RadialFields>(is_plane, a, bars, [&](double r) -> RadialFields::Values {
        return {profile.pressure(r), unknown, unknown, share * profile.integral(r, 1)};
    });
}

/// What cells count is that of the radius.
void set_area(Reference& reference) {
    const ReferenceValue& a = reference.values.at(keys::contact_radius);
    ReferenceValue& area = reference.values.at(keys::contact_area);
    const bool is_plane = reference.geometry == Geometry::plane;
    area.value = is_plane ? 2 * a.value : pi * a.value * a.value;
    area.grid = (is_plane ? 2 : 2 * pi * a.value) * a.grid;
}

/// The whole face of a punch with sharp edges.
bool is_pressed_in_full(const Reference& reference) {
    const contact::Case& c = reference.c;
    return c.indenter.shape == Case::Shape::flat_punch &&
           reference.contact_radius > (1 - 1e-6) * c.indenter.flat_radius;
}

void set_singular_edge(Reference& reference) {
    reference.has_singular_edge = true;
    reference.values.erase(keys::peak_pressure);
    reference.remarks.emplace_back(
        "the pressure is infinite at the edge: the largest pressure does not exist, and the fields "
        "of the reference are too low in its last element there");
}

/// What a penalty changes, and the stiffness, from states beside the end.
void add_neighbours(Reference& reference, const Case& pressed, const std::string& model,
                    const contact::ModelRunner& runner) {
    const NormalControl control = final_normal(pressed);
    const bool by_force = control.kind == NormalControl::Kind::force;
    const bool is_plane = reference.geometry == Geometry::plane;
    const double length = is_plane ? pressed.indenter.length : 1;
    std::array<double, 4> squares{}, answers{};
    constexpr std::array steps{-2., -1., 1., 2.};
    for (std::size_t k = 0; k < steps.size(); ++k) {
        Case near = on_elements(pressed, reference.contact_radius, elements_of_neighbours);
        auto& value = by_force ? near.load.normal_force : near.load.indentation;
        value = *value * (1 + neighbour_step * steps[k]);
        const EndState end = end_state(runner, model, near);
        const double a = end.scales.contact_radius;
        squares[k] = PressureProfile(end, a, is_plane).integral(a, 2);
        answers[k] = by_force ? end.record().indentation : end.record().normal_force / length;
    }
    const double step = neighbour_step * control.value / (by_force ? length : 1);
    const auto slope = [&](const std::array<double, 4>& f) {
        ReferenceValue value = central_difference(step, f[0], f[1], f[2], f[3]);
        value.source = model;
        return value;
    };
    ReferenceValue compliance = slope(squares), stiffness = slope(answers);
    compliance.value *= by_force ? .5 : -.5;
    compliance.grid *= .5;
    reference.effects.normal_compliance = compliance;
    if (by_force) {
        stiffness.grid /= stiffness.value * stiffness.value;
        stiffness.value = 1 / stiffness.value;
    }
    reference.values[keys::normal_stiffness] = stiffness;
}

/// The levels of the case, of so many elements in this radius.
std::vector<EndState> section_levels(const Case& c, double radius, const std::string& model,
                                     const contact::ModelRunner& runner,
                                     std::span<const double> counts) {
    std::vector<EndState> levels;
    for (const double count : counts) {
        levels.push_back(end_state(runner, model, on_elements(c, radius, count)));
        levels.back().size = radius / count;
    }
    return levels;
}

/// Of a path whose last two rows roll out and back: how long each is [m]; empty: another path.
std::optional<std::array<double, 2>> rolled_legs(const Case& c) {
    if (!c.prescribed_path || c.prescribed_path->rows.size() < 3) return {};
    const auto& rows = c.prescribed_path->rows;
    const std::size_t n = rows.size();
    const double out = rows[n - 2].offset[0] - rows[n - 3].offset[0],
                 back = rows[n - 1].offset[0] - rows[n - 2].offset[0];
    if (!(out * back < 0)) return {};
    return {{out, back}};
}

/// Shift per way rolled over the end of the leg that ends with this record.
double creep_before(const contact::History& history, std::size_t last, double way) {
    const auto& steps = history.steps;
    std::size_t first = last;
    constexpr double rounding = 1e-9;
    while (first > 0 &&
           std::abs(steps[last].offset[0] - steps[first].offset[0]) < way * (1 - rounding))
        --first;
    return (steps[last].shift[0] - steps[first].shift[0]) /
           std::abs(steps[last].offset[0] - steps[first].offset[0]);
}

/// Creep under a force, the mean of both directions: finite bodies creep without a force, too,
/// towards where they roll, which the mean is without.
void refer_section_that_rolls(Reference& reference, const std::array<double, 2>& legs,
                              double radius, const std::string& model,
                              const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    std::vector<EndState> levels;
    std::vector<double> sizes, creeps;
    for (const double count : elements_that_roll) {
        Case finer = on_elements(c, radius, count);
        auto& rows = finer.prescribed_path->rows;
        const double node = radius / count / 2;
        for (std::size_t k = 1; k < rows.size(); ++k)
            rows[k].steps = std::max(
                1, static_cast<int>(
                       std::lround(std::abs(rows[k].offset[0] - rows[k - 1].offset[0]) / node)));
        levels.push_back(end_state(runner, model, finer));
        levels.back().size = radius / count;
        sizes.push_back(levels.back().size);
        const contact::History& history = levels.back().history;
        const std::size_t last = history.steps.size() - 1, turned = last - rows.back().steps;
        const double way = measured_end * radius;
        creeps.push_back((creep_before(history, turned, way) + creep_before(history, last, way)) /
                         2);
    }
    reference.models = {model};
    reference.values = values_of_levels(c, levels, model);
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    set_area(reference);
    const auto creep = comparisons::estimate_limit(sizes, creeps);
    reference.values[keys::creepage] = {.value = creep.value, .grid = creep.error, .source = model};
    reference.fields = section_fields(reference, levels.back());
    reference.remarks.emplace_back(fmt::format(
        "creepage is the mean of both directions, shift per way rolled over the last a of {:.3g} "
        "and {:.3g} mm; all else is the end of the path",
        1e3 * std::abs(legs[0]), 1e3 * std::abs(legs[1])));
    reference.remarks.emplace_back("tractions along the surface are not compared");
}

bool rolls_or_follows_a_path(const Case& c) {
    return c.rolling || c.prescribed_path;
}

/// Friction leaves tractions, which hang on the path: the whole path on each mesh.
void refer_section_with_friction(Reference& reference, double radius, const std::string& model,
                                 const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    std::vector<EndState> levels = section_levels(c, radius, model, runner, elements_with_friction);
    // The last record is that of the tangential load, of 0, under which all that touches sticks.
    if (c.is_pressed_only())
        for (EndState& level : levels) level.history.steps.pop_back();
    reference.models = {model};
    reference.values = values_of_levels(c, levels, model);
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    set_area(reference);
    reference.fields = section_fields(reference, levels.back());
    reference.remarks.emplace_back(
        "tractions along the surface are not compared; stick area, force and shift are");
}

}  // namespace

bool has_finite_body(const Case& c) {
    return c.indenter.body.has_value() || c.has_hole();
}

void refer_section(Reference& reference, const contact::ModelRunner& runner) {
    const Case& c = reference.c;
    if (c.has_hole())
        throw contact::InputError(
            "reference: bodies of a finite size are assumed to lie on a flat substrate; compare "
            "with the problem pin_in_hole, or take a run of fem-plane as the reference");
    const bool is_plane = c.is_line_contact();
    const auto legs = rolled_legs(c);
    if (!legs && !is_frictionless(c) &&
        (rolls_or_follows_a_path(c) || !(is_plane || c.is_pressed_only())))
        throw contact::InputError(
            "reference: bodies of a finite size are assumed to be pressed, and with friction to be "
            "pulled once in plane strain or rolled out and back; remove path and rolling, or take "
            "a run of fem-plane as the reference");
    const std::string model =
        is_plane ? contact::models::fem_plane : contact::models::fem_axisymmetric;
    const Case pressed = pressed_alone(c, final_normal(c));
    const double radius = end_state(runner, model, pressed).scales.contact_radius;
    if (legs) {
        if (std::min(std::abs((*legs)[0]), std::abs((*legs)[1])) < least_rolled * radius)
            throw contact::InputError(fmt::format(
                "reference: creep is that of legs of {} a at least, {:.3g} mm here; roll farther, "
                "or take a run of fem-plane as the reference",
                least_rolled, 1e3 * least_rolled * radius));
        return refer_section_that_rolls(reference, *legs, radius, model, runner);
    }
    if (!is_frictionless(c)) return refer_section_with_friction(reference, radius, model, runner);
    const std::vector<EndState> levels =
        section_levels(pressed, radius, model, runner, elements_of_levels);
    reference.models = {model};
    reference.values = values_of_levels(pressed, levels, model);
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    set_area(reference);
    reference.fields = section_fields(reference, levels.back());
    if (is_pressed_in_full(reference)) set_singular_edge(reference);
    if (c.indenter.body->is_loose())
        // The place of a load on a face goes down without bound as elements shrink.
        for (const char* key : {keys::indentation, keys::stored_energy})
            reference.values.erase(key);
    else
        add_neighbours(reference, pressed, model, runner);
    if (c.has_rigid_substrate)
        // The normal is the plane's, and its height is the same where a point has moved along it.
        reference.effects.displaced_surface = ReferenceValue{.source = "the plane is flat"};
    else
        reference.remarks.emplace_back(
            "what contact on the displaced surface changes between two bodies is not computed");
}

}  // namespace tricontact::benchmarks
