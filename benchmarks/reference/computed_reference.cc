#include <algorithm>
#include <cmath>
#include <functional>

#include "benchmarks/reference/model_levels.h"
#include "benchmarks/reference/reference_kinds.h"
#include "contact/cells.h"
#include "contact/half_space_scales.h"
#include "contact/models/model_kind.h"

namespace tricontact::benchmarks {

namespace {

using contact::Case;
using contact::NormalControl;
using contact::TangentialControl;
namespace keys = quantity_keys;

/// Neighbours of the state are computed on coarse cells, steps of this share of depth, force or
/// shift apart: differences of a few percent of effects that are small themselves.
constexpr double neighbours_cells = 14, neighbours_step = .04;

Case on_neighbours_cells(Case c) {
    auto& cells = c.of<contact::Cells>();
    cells.spacing.reset();
    cells.per_radius = neighbours_cells;
    return c;
}

/// All normal loads of the path times a factor.
Case with_normal(Case c, double factor) {
    if (c.prescribed_path)
        for (auto& row : c.prescribed_path->rows) row.normal.value *= factor;
    if (c.load.normal_force) *c.load.normal_force *= factor;
    if (c.load.indentation) *c.load.indentation *= factor;
    return c;
}

/// The last row's tangential control along x times a factor; empty where there is none.
std::optional<Case> with_tangential(Case c, double factor) {
    if (c.rolling) return {};
    if (c.prescribed_path) {
        double& value = c.prescribed_path->rows.back().tangential[0].value;
        if (value == 0) return {};
        value *= factor;
        return c;
    }
    if (c.load.tangential_force.value_or(0) == 0 && c.load.tangential_ratio.value_or(0) == 0)
        return {};
    if (c.load.tangential_force) *c.load.tangential_force *= factor;
    if (c.load.tangential_ratio) *c.load.tangential_ratio *= factor;
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

/// The end state between two neighbours.
struct StatesAround {
    EndState below, here, above;
    EnvelopeIntegrals i_below, i_here, i_above;

    ReferenceValue slope(const std::function<double(const EndState&)>& x,
                         double EnvelopeIntegrals::*f) const {
        return slope_of(x(below), x(here), x(above), i_below.*f, i_here.*f, i_above.*f);
    }
    ReferenceValue slope(const std::function<double(const EndState&)>& x,
                         const std::function<double(const EndState&)>& f) const {
        return slope_of(x(below), x(here), x(above), f(below), f(here), f(above));
    }
};

double depth_of(const EndState& e) {
    return e.record().indentation;
}
double shift_of(const EndState& e) {
    return e.record().shift[0];
}

double edge_slope(const Case& c, double radius) {
    return std::abs(c.make_indenter()->slope(radius, 0)[0]);
}

class EffectsOfNeighbours {
  public:
    EffectsOfNeighbours(Reference& reference, const Case& c, const contact::ModelRunner& runner,
                        const std::string& model)
        : reference_(reference),
          runner_(runner),
          model_(model),
          case_(on_neighbours_cells(c)),
          length_(case_.is_line_contact() ? case_.indenter.length : 1),
          here_(end_state(runner, model, case_)) {}

    void add() {
        if (!reference_.effects.normal_compliance) add_normal();
        if (with_tangential(case_, 1)) add_tangential();
        if (is_pressed_in_steps()) add_one_step();
    }

  private:
    StatesAround neighbours(const Case& below, const Case& above) const {
        StatesAround n{end_state(runner_, model_, below),
                       here_,
                       end_state(runner_, model_, above),
                       {},
                       {},
                       {}};
        n.i_below = envelope_integrals(below, n.below);
        n.i_here = envelope_integrals(case_, n.here);
        n.i_above = envelope_integrals(above, n.above);
        return n;
    }
    double force_of(const EndState& e) const { return e.record().normal_force / length_; }
    double tangential_of(const EndState& e) const {
        return e.record().tangential_force[0] / length_;
    }
    bool is_pressed_in_steps() const {
        return !is_uncoupled(case_) && case_.load.press == Case::Press::friction &&
               case_.load.press_steps > 1;
    }

    void add_normal() {
        const StatesAround n = neighbours(with_normal(case_, 1 - neighbours_step),
                                          with_normal(case_, 1 + neighbours_step));
        FirstOrderEffects& effects = reference_.effects;
        const bool by_force = final_normal(case_).kind == NormalControl::Kind::force;
        const auto force = [this](const EndState& e) { return force_of(e); };
        const std::function<double(const EndState&)> along =
            by_force ? std::function<double(const EndState&)>(force) : depth_of;
        const double sign = by_force ? 1 : -1;
        effects.normal_compliance =
            times(n.slope(along, &EnvelopeIntegrals::pressure_squared), sign / 2);
        if (!case_.is_line_contact() || case_.layer.thickness)
            if (!reference_.find(keys::normal_stiffness))
                reference_.values[keys::normal_stiffness] = with_source(n.slope(depth_of, force));
        // A model that leaves coupling out does not know how pressure moves the surface.
        if (!case_.contact.coupling && would_couple(case_)) return;
        effects.displaced_surface = times(n.slope(along, &EnvelopeIntegrals::work_of_slope), sign);
        effects.displaced_surface->model = second_order_of_slope *
                                           edge_slope(case_, reference_.contact_radius) *
                                           std::abs(effects.displaced_surface->value);
    }

    void add_tangential() {
        const StatesAround n = neighbours(*with_tangential(case_, 1 - neighbours_step),
                                          *with_tangential(case_, 1 + neighbours_step));
        const bool by_shift =
            case_.prescribed_path &&
            case_.prescribed_path->rows.back().tangential[0].kind == TangentialControl::Kind::shift;
        const auto force = [this](const EndState& e) { return tangential_of(e); };
        const std::function<double(const EndState&)> along =
            by_shift ? std::function<double(const EndState&)>(shift_of) : force;
        reference_.effects.tangential_compliance =
            times(n.slope(along, &EnvelopeIntegrals::traction_squared), by_shift ? -.5 : .5);
        if (!case_.is_line_contact() || case_.layer.thickness)
            reference_.values[keys::tangential_stiffness] = with_source(n.slope(shift_of, force));
    }

    void add_one_step() {
        Case in_one_step = case_;
        in_one_step.load.press_steps = 1;
        const auto other = scalars_of(case_, end_state(runner_, model_, in_one_step));
        for (const auto& [key, value] : scalars_of(case_, here_))
            if (const auto found = other.find(key); found != other.end()) {
                const double change = found->second - value;
                reference_.effects.one_step[key] = {
                    .value = change, .grid = std::abs(change) / 5, .source = model_};
            }
    }

    /// On coarse cells: a share that those of the path's end have, too.
    ReferenceValue with_source(ReferenceValue value) const {
        value.source = model_;
        return value;
    }

    Reference& reference_;
    const contact::ModelRunner& runner_;
    std::string model_;
    Case case_;
    double length_;
    EndState here_;
};

/// Without friction coupling changes no force, but tells how the surface moves along itself.
Case with_displacements(Case c) {
    if (c.contact.coupling || !is_frictionless(c) || c.prescribed_path) return c;
    c.contact.coupling = true;
    c.load.press = Case::Press::frictionless;
    return c;
}

bool has_tractions(const Reference& reference, const EndState& finest) {
    const auto largest = [](const std::vector<double>& values) {
        double most = 0;
        for (const double value : values) most = std::max(most, std::abs(value));
        return most;
    };
    return std::max(largest(finest.surface.tangential_traction_x),
                    largest(finest.surface.tangential_traction_y)) >
           1e-6 * largest(finest.surface.normal_traction) *
               std::max(1., reference.c.friction.law()->ratio_at(1));
}

}  // namespace

void refer_computed(Reference& reference, const contact::ModelRunner& runner) {
    const Case c = with_displacements(reference.c);
    const std::string model = c.layer.thickness ? contact::models::bem_layer : contact::models::bem;
    const std::vector<EndState> levels = end_states(runner, model, c);
    reference.models = {model};
    reference.values = values_of_levels(reference.c, levels, model);
    reference.contact_radius = reference.values.at(keys::contact_radius).value;
    const auto fields = fields_of_levels(levels);
    reference.fields = fields;
    reference.has_tractions = has_tractions(reference, levels.back());
    if (is_uncoupled(reference.c) && has_exact_radial_contact(c))
        take_radial_pressing(reference, fields);
    if (is_uncoupled(reference.c) && has_exact_line_contact(c))
        take_line_pressing(reference, fields);
    take_closed_shearing(reference);
    if (!c.rolling) EffectsOfNeighbours(reference, c, runner, model).add();
}

}  // namespace tricontact::benchmarks
