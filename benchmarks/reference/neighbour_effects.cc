#include "benchmarks/reference/neighbour_effects.h"

#include <cmath>

#include "benchmarks/reference/reference_kinds.h"
#include "contact/cells.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::TangentialControl;
namespace keys = quantity_keys;

/// Differences of a few percent of effects that are small themselves: coarse cells do.
constexpr double neighbours_cells = 14, neighbours_step = .04;
constexpr double of_one_step = .2;  // what coarse cells leave of the change

Case on_neighbours_cells(Case c) {
    auto& cells = c.of<contact::Cells>();
    cells.spacing.reset();
    cells.per_radius = neighbours_cells;
    return c;
}

/// All normal loads of the path times a factor.
Case with_normal_times(Case c, double factor) {
    if (c.prescribed_path)
        for (auto& row : c.prescribed_path->rows) row.normal.value *= factor;
    if (c.load.normal_force) *c.load.normal_force *= factor;
    if (c.load.indentation) *c.load.indentation *= factor;
    return c;
}

/// The last tangential control along x times a factor; empty where there is none.
std::optional<Case> with_tangential_times(Case c, double factor) {
    if (c.prescribed_path) {
        double& value = c.prescribed_path->rows.back().tangential[0].value;
        if (value == 0) return {};
        value *= factor;
        return c;
    }
    if (!c.load.is_tangential()) return {};
    if (c.load.tangential_force) *c.load.tangential_force *= factor;
    if (c.load.tangential_ratio) *c.load.tangential_ratio *= factor;
    return c;
}

/// Pressed with friction in one step instead of several; empty where that is no matter.
std::optional<Case> pressed_in_one_step(Case c) {
    if (is_uncoupled(c) || c.load.press != Case::Press::friction) return {};
    int& steps = c.prescribed_path && c.prescribed_path->starts_unloaded()
                     ? c.prescribed_path->rows[1].steps
                     : c.load.press_steps;
    if (steps <= 1) return {};
    steps = 1;
    return c;
}

/// Slope of f over x from three states; the bar is half of what both sides differ by.
ReferenceValue slope_of(double x0, double x1, double x2, double f0, double f1, double f2) {
    const double left = (f1 - f0) / (x1 - x0), right = (f2 - f1) / (x2 - x1);
    return {.value = (f2 - f0) / (x2 - x0),
            .grid = std::abs(right - left) / 2,
            .source = "envelope theorem"};
}

ReferenceValue times(ReferenceValue value, double factor) {
    value.value *= factor;
    value.grid *= std::abs(factor);
    return value;
}

double depth_of(const EndState& e) {
    return e.record().indentation;
}
double shift_of(const EndState& e) {
    return e.record().shift[0];
}
double normal_force_of(const EndState& e) {
    return e.record().normal_force;
}
double tangential_force_of(const EndState& e) {
    return e.record().tangential_force[0];
}

bool is_shift_prescribed(const Case& c) {
    return c.prescribed_path &&
           c.prescribed_path->rows.back().tangential[0].kind == TangentialControl::Kind::shift;
}

}  // namespace

NeighbourEffects::NeighbourEffects(const Case& c, const contact::ModelRunner& runner,
                                   const std::string& model, bool with_normal)
    : runner_(runner),
      model_(model),
      case_(on_neighbours_cells(c)),
      length_(c.is_line_contact() ? c.indenter.length : 1),
      here_(end_state(runner, model, case_)),
      i_here_(envelope_integrals(case_, here_)) {
    constexpr double less = 1 - neighbours_step, more = 1 + neighbours_step;
    if (with_normal)
        normal_ = around(with_normal_times(case_, less), with_normal_times(case_, more));
    if (with_tangential_times(case_, 1))
        tangential_ =
            around(*with_tangential_times(case_, less), *with_tangential_times(case_, more));
    if (const auto other = pressed_in_one_step(case_))
        in_one_step_ = end_state(runner, model, *other);
}

NeighbourEffects::StatesAround NeighbourEffects::around(const Case& below,
                                                        const Case& above) const {
    StatesAround states{
        end_state(runner_, model_, below), end_state(runner_, model_, above), {}, {}};
    states.i_below = envelope_integrals(below, states.below);
    states.i_above = envelope_integrals(above, states.above);
    return states;
}

ReferenceValue NeighbourEffects::slope(const StatesAround& states, Number x,
                                       double EnvelopeIntegrals::*f) const {
    return slope_of(x(states.below), x(here_), x(states.above), states.i_below.*f, i_here_.*f,
                    states.i_above.*f);
}

ReferenceValue NeighbourEffects::slope(const StatesAround& states, Number x, Number f) const {
    ReferenceValue value = slope_of(x(states.below), x(here_), x(states.above), f(states.below),
                                    f(here_), f(states.above));
    value.source = model_;
    return value;
}

void NeighbourEffects::add_to(Reference& reference) const {
    if (normal_) add_normal(reference);
    if (tangential_) add_tangential(reference);
    if (in_one_step_) add_one_step(reference);
}

// Forces are those of the whole length of a line contact, integrals those over x.
void NeighbourEffects::add_normal(Reference& reference) const {
    FirstOrderEffects& effects = reference.effects;
    const bool by_force = final_normal(case_).kind == NormalControl::Kind::force;
    const Number along = by_force ? normal_force_of : depth_of;
    const double factor = by_force ? length_ : -1;
    effects.normal_compliance =
        times(slope(*normal_, along, &EnvelopeIntegrals::pressure_squared), factor / 2);
    if (has_datum() && !reference.find(keys::normal_stiffness))
        reference.values[keys::normal_stiffness] =
            times(slope(*normal_, depth_of, normal_force_of), 1 / length_);
    // A model that leaves coupling out does not know how pressure moves the surface.
    if (!case_.contact.coupling && would_couple(case_)) return;
    ReferenceValue displaced =
        times(slope(*normal_, along, &EnvelopeIntegrals::work_of_slope), factor);
    const double edge_slope = case_.make_indenter()->slope(reference.contact_radius, 0)[0];
    displaced.model = second_order_of_slope * std::abs(edge_slope * displaced.value);
    effects.displaced_surface = displaced;
}

void NeighbourEffects::add_tangential(Reference& reference) const {
    const bool by_shift = is_shift_prescribed(case_);
    const Number along = by_shift ? shift_of : tangential_force_of;
    reference.effects.tangential_compliance =
        times(slope(*tangential_, along, &EnvelopeIntegrals::traction_squared),
              (by_shift ? -1 : length_) / 2);
    if (has_datum())
        reference.values[keys::tangential_stiffness] =
            times(slope(*tangential_, shift_of, tangential_force_of), 1 / length_);
}

void NeighbourEffects::add_one_step(Reference& reference) const {
    const auto other = scalars_of(case_, *in_one_step_);
    for (const auto& [key, value] : scalars_of(case_, here_))
        if (const auto found = other.find(key); found != other.end()) {
            const double change = found->second - value;
            reference.effects.one_step[key] = {
                .value = change, .grid = of_one_step * std::abs(change), .source = model_};
        }
}

}  // namespace tricontact::benchmarks
