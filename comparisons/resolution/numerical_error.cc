#include "comparisons/resolution/numerical_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <utility>

#include "comparisons/resolution/refinement.h"
#include "contact/base/between_rows.h"
#include "contact/models/model_kind.h"
#include "contact/rig_stiffness.h"

namespace tricontact::comparisons {

namespace {

using contact::Case;
using contact::State;
using json = nlohmann::ordered_json;

constexpr double factor_of_two_meshes = 3;  // Roache (1998), ch. 5
constexpr std::size_t most_band_points = 600;

// A quarter of the steps' length leaves a quarter of an error of the first order.
constexpr double of_quarter_steps = 4. / 3;
// Sides that are 1.5 times as far apart: what the second power of their distance leaves.
constexpr double of_wider_block = 1.8;
constexpr double of_tolerance = 10;
// What separates the coarsest meshes counts half; where there is no order, it counts as it is: of
// what is counted in cells (a period's increment in those that slip), and on springs, which bring
// an error that depends on where between two of them the contact ends, of either sign.
constexpr double first_order = .5, no_order = 1;
constexpr double of_work = 2.5;
constexpr double of_slow_meshes = std::numbers::sqrt2 + 1;

/// What differences count for. The error of frictional work falls with the power 2/3 of the steps'
/// length, as the slip of a contact that grows does: half the steps change 1/1.7 of it. With the
/// two to six steps of runs drawn at random it falls more slowly yet; 2.5 covers 95 % of them.
struct Factors {
    double coarsest = first_order, steps = 1;
};

/// `value`: of a run, empty if it has none. Without what is less than rounding and tolerances.
template <class Value>
std::optional<double> half_width(const NumericalError& error, const Value& value,
                                 const Factors& factors = {}) {
    if (!error.run || !error.coarser) return {};
    const std::optional<double> fine = value(*error.run), coarse = value(*error.coarser);
    if (!fine || !coarse) return {};
    const double change = std::abs(*fine - *coarse);
    double mesh = factor_of_two_meshes * change;
    if (error.coarsest) {
        // A contact that lets go may be too few points across there.
        const std::optional<double> coarsest = value(*error.coarsest);
        if (!coarsest && !error.is_slow) return {};
        if (coarsest)
            mesh =
                safety_factor * std::max(change, factors.coarsest * std::abs(*coarse - *coarsest));
    }
    if (error.is_slow) mesh *= of_slow_meshes;
    double rest = 0;
    const std::array others{std::pair(&error.long_steps, factors.steps),
                            std::pair(&error.short_steps, factors.steps * of_quarter_steps),
                            std::pair(&error.wide_block, of_wider_block)};
    for (const auto& [other, factor] : others) {
        if (!*other) continue;
        const std::optional<double> changed = value(**other);
        if (!changed) return {};
        rest += factor * std::abs(*coarse - *changed);
    }
    return mesh + safety_factor * rest;
}

/// The force is flat where it lets go. By JKR F'' a^2 = 9/2 F there: what the force is off by moves
/// the radius by its root.
double least_pull_off_radius_error(const NumericalError& error) {
    if (contact::model_kind(error.model).is_on_line()) return 0;  // which find the place exactly
    const auto force = error.run->results.number(quantities::pull_off_force);
    const auto off = error.of(quantities::pull_off_force);
    if (!force || !off || !(*force > 0)) return 0;
    return 2. / 3 * std::sqrt(*off / *force) *
           error.run->results.number(quantities::pull_off_radius).value_or(0);
}

Factors factors_of(const NumericalError& error, const Quantity& q) {
    return {.coarsest = q.is_counted || !contact::model_kind(error.model).converges_in_order
                            ? no_order
                            : first_order,
            .steps = is_work(q) ? of_work : 1};
}

}  // namespace

bool is_work(const Quantity& q) {
    return &q == &quantities::path_work || &q == &quantities::dissipation ||
           &q == &quantities::friction_energy;
}

double error_scale(const Quantity& q, const Results& r) {
    using namespace quantities;
    const auto size = [&](const Quantity& one) { return std::abs(r.number(one).value_or(0)); };
    const auto is_one_of = [&](auto... list) { return ((&q == list) || ...); };
    const double value = size(q);
    if (q.over == std::string_view("U_max")) return 1;
    if (is_one_of(&path_force, &end_normal_force)) return std::max(value, size(normal_force));
    if (is_one_of(&end_indentation)) return std::max(value, size(indentation));
    if (is_one_of(&static_shift, &final_shift, &settled_shift, &shift_increment))
        return std::max(value, size(unit_shift));
    if (is_work(q)) return std::max(value, size(normal_force) * size(unit_shift));
    if (is_one_of(&stored_energy)) return std::max(value, size(normal_force) * size(indentation));
    if (is_one_of(&contact_area, &stick_area, &slip_area))
        return std::max({value, size(contact_area), size(contact_radius) * size(contact_radius)});
    return value;
}

double least_area_error(const Quantity& q, const Results& r, const std::string& model,
                        double cell) {
    using namespace quantities;
    if (&q != &contact_area && &q != &stick_area && &q != &slip_area) return 0;
    // Of the drawn runs 95 % of areas are off by less: cells along a circle average, springs do
    // not.
    const double share = contact::model_kind(model).is_on_line() ? .5 : .25;
    const double edges = &q == &slip_area ? std::numbers::sqrt2 : 1;  // two of them
    const double area = r.number(contact_area).value_or(0);
    const double radius = r.number(contact_radius).value_or(0);
    const double of_circle = 2 * std::sqrt(std::numbers::pi * area);
    return share * edges * cell * (radius > 0 ? std::max(of_circle, 2 * area / radius) : of_circle);
}

ResolvedRun::ResolvedRun(const contact::Case& c, const contact::History& history)
    : results(c, history) {
    if (history.steps.empty()) return;
    // Loading comes at the first phase.
    const double first = history.steps.front().phase;
    phases.push_back(first);
    shifts.push_back(c.prescribed_path ? history.steps.front().shift[0] : history.static_shift);
    for (const contact::StepRecord& step : history.steps)
        if (step.phase > phases.back()) {
            phases.push_back(step.phase);
            shifts.push_back(step.shift[0]);
        }
}

double ResolvedRun::shift_at(double phase) const {
    return contact::between_rows(phases, shifts, std::clamp(phase, phases.front(), phases.back()));
}

std::optional<double> NumericalError::of(const Quantity& q) const {
    if (&q == &quantities::normal_stiffness) return normal_stiffness;
    if (&q == &quantities::tangential_stiffness) return tangential_stiffness;
    if (is_exact(q)) return run && run->results.number(q) ? std::optional(0.) : std::nullopt;
    const auto width = half_width(
        *this, [&q](const ResolvedRun& r) { return r.results.number(q); }, factors_of(*this, q));
    if (!width) return {};
    return std::max({*width, of_tolerance * tolerance * error_scale(q, run->results),
                     least_area_error(q, run->results, model, cell),
                     &q == &quantities::pull_off_radius ? least_pull_off_radius_error(*this) : 0});
}

bool NumericalError::is_exact(const Quantity& q) const {
    return std::ranges::find(prescribed, &q) != prescribed.end();
}

const std::vector<const Quantity*>& quantities_with_error() {
    using namespace quantities;
    static const std::vector<const Quantity*> list{&normal_force,
                                                   &indentation,
                                                   &contact_radius,
                                                   &peak_pressure,
                                                   &unit_shift,
                                                   &static_shift,
                                                   &final_shift,
                                                   &settled_shift,
                                                   &shift_increment,
                                                   &dissipation,
                                                   &settled_shift_ratio,
                                                   &shift_increment_ratio,
                                                   &path_work,
                                                   &path_force,
                                                   &end_normal_force,
                                                   &end_indentation,
                                                   &contact_area,
                                                   &stick_area,
                                                   &slip_area,
                                                   &stored_energy,
                                                   &friction_energy,
                                                   &normal_stiffness,
                                                   &pull_off_force,
                                                   &pull_off_radius,
                                                   &pull_off_indentation,
                                                   &last_indentation};
    return list;
}

std::vector<const Quantity*> prescribed_quantities(const Case& c) {
    using contact::NormalControl;
    using contact::TangentialControl;
    std::vector<const Quantity*> list;
    const bool by_path = c.prescribed_path.has_value();
    const bool by_depth =
        by_path ? c.prescribed_path->hardest_normal().kind == NormalControl::Kind::indentation
                : c.load.indentation.has_value();
    const contact::RigStiffness& rig = c.of<contact::RigStiffness>();
    const auto add_normal = [&](bool is_depth, const Quantity& depth, const Quantity& force) {
        if (!is_depth || !rig.normal) list.push_back(is_depth ? &depth : &force);
    };
    add_normal(by_depth, quantities::indentation, quantities::normal_force);
    const bool ends_by_depth =
        by_path ? c.prescribed_path->rows.back().normal.kind == NormalControl::Kind::indentation
                : by_depth;
    add_normal(ends_by_depth, quantities::end_indentation, quantities::end_normal_force);
    if (!by_path) return list;
    const TangentialControl::Kind along = c.prescribed_path->rows.back().tangential[0].kind;
    if (along == TangentialControl::Kind::shift && !rig.tangential)
        list.push_back(&quantities::final_shift);
    if (along == TangentialControl::Kind::force) list.push_back(&quantities::path_force);
    return list;
}

report::Band NumericalError::shift_band(double unit) const {
    report::Band band;
    if (!run || !coarser) return band;
    double begin = 0;  // where all have a shift: longer steps of a path end later
    for (const auto* one : {&run, &coarser, &coarsest, &long_steps, &short_steps, &wide_block})
        if (*one && !(*one)->phases.empty()) begin = std::max(begin, (*one)->phases.front());
    for (const std::size_t k : report::thinned(run->phases.size(), most_band_points)) {
        const double phase = run->phases[k], shift = run->shifts[k];
        if (phase < begin) continue;
        const auto at_phase = [phase](const ResolvedRun& r) {
            return std::optional(r.shift_at(phase));
        };
        const double width =
            half_width(*this, at_phase, factors_of(*this, quantities::final_shift)).value_or(0);
        band.x.push_back(phase);
        band.low.push_back((shift - width) / unit);
        band.high.push_back((shift + width) / unit);
    }
    return band;
}

std::optional<State> NumericalError::other_state() const {
    if (!run) return {};
    const auto decided = [](std::optional<State> state) {
        return state && *state != State::undecided;
    };
    const std::optional<State> own = run->results.state();
    if (!decided(own)) return {};
    for (const auto* other : {&coarser, &coarsest, &long_steps, &short_steps, &wide_block})
        if (*other && decided((*other)->results.state()) && (*other)->results.state() != own)
            return (*other)->results.state();
    return {};
}

json numerical_error_json(const NumericalError& error) {
    if (error.model.empty()) return {};
    json widths = json::object(), exact = json::array();
    for (const Quantity* q : quantities_with_error()) {
        if (const auto width = error.of(*q)) widths[q->key] = *width;
        if (widths.contains(q->key) && error.is_exact(*q)) exact.push_back(q->key);
    }
    const auto other = error.other_state();
    json fields = json::object();
    for (const FieldBar& bar : error.fields)
        fields[bar.field] = {{std::string("largest_") + bar.unit, bar.largest}, {"l2", bar.l2}};
    return {{"model", error.model},
            {"half_widths", widths},
            {"fields", fields},
            {"exact", exact},
            {"other_state", other ? json(contact::name_of(*other)) : json()},
            {"why_none", error.why_none.empty() ? json() : json(error.why_none)},
            {"why_no_steps", error.why_no_steps.empty() ? json() : json(error.why_no_steps)},
            {"why_no_normal_stiffness",
             error.why_no_stiffness.empty() ? json() : json(error.why_no_stiffness)}};
}

}  // namespace tricontact::comparisons
