#include "experiments/identification/measured_values.h"

#include <algorithm>
#include <cmath>

#include "atlas/prediction.h"
#include "atlas/shipped.h"
#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/quantities.h"
#include "contact/larger_grids.h"
#include "contact/load_path.h"
#include "experiments/identification/adhesive_values.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/layer_contact.h"
#include "experiments/identification/loop_values.h"
#include "experiments/records/experiment_evaluation.h"
#include "io/case/measurement_models.h"
#include "theory/cattaneo_mindlin.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using contact::NormalControl;
using Measurement = IdentificationInput::Measurement;

// Of free rolling: the last one's dU/dW is that of all further ones to 1e-4.
constexpr int wobble_periods = 3;

/// Pressed as the case says.
void press(contact::Model& model, const Case& c) {
    contact::LoadStep step = contact::press_step(c);
    step.friction = false;
    model.advance(step);
    if (!model.is_coupled()) return;
    const contact::Scales scales = model.scales();
    model.release();
    const auto path = contact::make_load_path(c, scales.normal_force, scales.contact_radius);
    for (const auto& pressing : path.pressing) model.advance(pressing);
}

/// The rig pressed without friction by a force, or to a depth.
Case pressed(const Case& rig, const NormalControl& control) {
    Case c = rig;
    // Scales of other laws cost integrals, and nothing asks for them.
    if (!c.friction.is_coulomb()) c.friction = {.coefficient = 1};
    c.load.normal_force.reset();
    c.load.indentation.reset();
    (control.kind == NormalControl::Kind::force ? c.load.normal_force : c.load.indentation) =
        control.value;
    return c;
}

std::vector<Pressed> presses_of_model(const std::string& name, const Case& rig,
                                      const std::vector<NormalControl>& controls,
                                      const contact::ModelRunner& runner) {
    // The deepest one decides how far the model reaches.
    const auto deepest = std::ranges::max(controls, {}, &NormalControl::value);
    const auto model = runner.make(name, pressed(rig, deepest));
    const auto presses = contact::on_large_enough_grid(*model, [&] {
        std::vector<Pressed> all;
        for (const auto& control : controls) {
            model->release();
            contact::LoadStep step = contact::press_step(pressed(rig, control));
            step.friction = false;
            const auto record = model->advance(step);
            all.push_back(
                {record.normal_force, model->scales().contact_radius, record.indentation});
        }
        return all;
    });
    contact::require_sound(model->audit(), name);
    return presses;
}

/// Of the maps of the layer. Throws InputError where they are not about the rig, or do not reach.
std::vector<atlas::Value> mapped_shifts(Case c, const std::vector<double>& forces) {
    const atlas::Atlas& maps = atlas::shipped("sphere_layer_static");
    std::vector<atlas::Value> shifts;
    for (const double force : forces) {
        // Below the maps' least load the shift goes on as that of the half-space.
        const double least_load = maps.axis("load.tangential_ratio")->from;
        const double f = force / (c.friction_coefficient() * *c.load.normal_force);
        const double read = std::max(f, least_load);
        c.load.set_tangential_ratio(read);
        const atlas::Prediction p = atlas::predict(c, contact::models::bem_layer);
        const auto* shift = p.find(comparisons::quantities::static_shift);
        if (!shift)
            throw contact::InputError(
                "models: atlas: " + (p.gaps.empty() ? "no static shift" : p.gaps.front()) +
                "; take bem-layer");
        const double of_read = theory::static_shift_ratio(f) / theory::static_shift_ratio(read);
        shifts.push_back({of_read * shift->value.value, of_read * shift->value.error});
    }
    return shifts;
}

}  // namespace

std::vector<Pressed> presses(const std::string& model, const Case& rig,
                             const std::vector<NormalControl>& controls,
                             const contact::ModelRunner& runner) {
    // Without friction the layer's exact theory is what its maps and elements approximate.
    const io::MeasurementModel& kind = io::measurement_model(model);
    if (kind.approximates_theory) return presses(io::layer_theory().name, rig, controls, runner);
    if (kind.is_layer && rig.interface.normal_stiffness) {
        std::vector<Pressed> all;
        for (const auto& control : controls) all.push_back(layer_press(rig, control));
        return all;
    }
    // Springs coupled by any layers make the normal contact exact but for their spacing.
    const bool exact =
        kind.is_layer && kind.is_theory && comparisons::why_no_exact_theory(rig).empty();
    if (kind.is_layer && !exact) return presses_of_model(shift_model(model), rig, controls, runner);
    std::vector<Pressed> all;
    for (const auto& control : controls)
        if (exact) {
            const auto layer = theory::solve_layer_contact(
                comparisons::elastic_layer(rig), *rig.make_axisymmetric_indenter(), control);
            all.push_back({layer.normal_force, layer.contact_radius, layer.indentation});
        } else {
            all.push_back(half_space_press(rig, control));
        }
    return all;
}

bool is_coupled(const std::string& model, const Case& rig, const contact::ModelRunner& runner) {
    const contact::ModelKind* kind = contact::find_model_kind(model);
    if (!kind) return false;  // closed forms
    return kind->is_read() || runner.make(model, rig)->is_coupled();
}

double largest_offset(const std::vector<double>& offsets) {
    return std::abs(std::ranges::max(offsets, {}, [](double w) { return std::abs(w); }));
}

double own_wobble(const std::string& model, const Case& rig, double amplitude,
                  const contact::ModelRunner& runner) {
    if (!is_coupled(model, rig, runner)) return 0;
    Case c = rig;
    c.load.set_tangential_ratio(0);
    c.rolling = Case::Rolling{.amplitude = amplitude, .periods = wobble_periods, .run_all = true};
    const contact::History history = runner.history_of(model, c);
    return model_wobble(history.steps, history.steps.back().phase - 1, c.rolling->angle);
}

std::vector<double> rolled_shifts(const IdentifiedRig& rig, double own,
                                  const std::vector<double>& offsets) {
    std::vector<double> shifts;
    for (const double offset : offsets)
        shifts.push_back(offset * (own + rig.pivot_height / rig.as_case.indenter.radius));
    return shifts;
}

std::string shift_model(const std::string& model) {
    const io::MeasurementModel& kind = io::measurement_model(model);
    return kind.is_layer ? kind.model : model;
}

std::vector<double> static_shift_errors(const std::string& name, const Case& rig,
                                        const std::vector<double>& forces) {
    if (!contact::model_kind(name).is_read()) return {};
    std::vector<double> errors;
    for (const atlas::Value& value : mapped_shifts(rig, forces))
        errors.push_back(value.standard_error());
    return errors;
}

std::vector<double> static_shifts(const std::string& name, const Case& rig,
                                  const std::vector<double>& forces,
                                  const contact::ModelRunner& runner) {
    if (contact::model_kind(name).is_read()) {
        std::vector<double> shifts;
        for (const atlas::Value& value : mapped_shifts(rig, forces)) shifts.push_back(value.value);
        return shifts;
    }
    const auto model = runner.make(name, rig);
    // Close to sliding friction moves a coupled contact aside, over the edge of a grid that
    // pressing alone had room on.
    const auto shifts = contact::on_large_enough_grid(*model, [&] {
        press(*model, rig);
        const std::string state = model->write_state();
        std::vector<double> all;
        for (const double force : forces) {
            model->read_state(state);
            contact::LoadStep step = contact::press_step(rig);
            step.tangential[0].value = force;
            all.push_back(model->advance(step).shift[0]);
        }
        return all;
    });
    contact::require_sound(model->audit(), name);
    return shifts;
}

std::vector<NormalControl> controls_of(const IdentificationInput::Table& table, const Case& rig,
                                       const std::vector<double>& given) {
    std::vector<NormalControl> controls;
    switch (table.measurement) {
        case Measurement::force_indentation:
            for (const double depth : given)
                controls.push_back({NormalControl::Kind::indentation, depth});
            break;
        case Measurement::force_relaxation:
            controls.push_back({NormalControl::Kind::indentation, table.held});
            break;
        case Measurement::indentation_creep: {
            // A contact that only grows has at t the depth of an elastic one under F J(t)/J(inf)
            // (Lee and Radok 1960, J. Appl. Mech. 27, 438).
            const contact::Retardation creep(*rig.relaxation, 0);
            for (const double t : given) {
                double compliance = creep.relaxed;
                for (const auto& branch : creep.branches)
                    compliance -= branch.compliance * std::exp(-t / branch.time);
                controls.push_back({NormalControl::Kind::force, table.held * compliance});
            }
            break;
        }
        default:
            for (const double force : given)
                controls.push_back({NormalControl::Kind::force, force});
    }
    return controls;
}

std::vector<double> values_of_presses(const IdentificationInput::Table& table, const Case& rig,
                                      const std::vector<double>& given,
                                      const std::vector<Pressed>& all) {
    std::vector<double> values;
    switch (table.measurement) {
        case Measurement::force_relaxation:  // F(t)/F(inf) = G(t)/G_inf
            for (const double t : given) {
                double ratio = 1;
                for (const auto& [share, time] : rig.relaxation->branches)
                    ratio += share * std::exp(-t / time);
                values.push_back(all.front().normal_force * ratio);
            }
            break;
        case Measurement::force_indentation:
            for (const Pressed& one : all) values.push_back(one.normal_force);
            break;
        case Measurement::indentation_creep:
            for (const Pressed& one : all) values.push_back(one.indentation);
            break;
        default:
            for (const Pressed& one : all) values.push_back(one.contact_radius);
    }
    return values;
}

std::vector<double> from_zero_depth(
    const IdentificationInput::Table& table, const IdentifiedRig& rig,
    const std::vector<double>& given,
    const std::function<std::vector<double>(const std::vector<double>&)>& values) {
    // Of depths and forces alone: times and ratios begin at 0.
    const bool presses = table.measurement == Measurement::force_indentation ||
                         table.measurement == Measurement::contact_radius;
    if (!table.has_free_zero && (!presses || std::ranges::min(given) > 0)) return values(given);
    const double zero = table.has_free_zero ? rig.zero_depths.at(table.place) : 0;
    // Forces go with the depth's power 3/2 at least: below this of the deepest there is none.
    constexpr double least = 1e-6;
    const double deepest = std::ranges::max(given) - zero;
    if (!(deepest > 0)) throw contact::InputError("zero_depth: no row is in contact");
    std::vector<double> depths;
    for (const double depth : given)
        if (depth - zero > least * deepest) depths.push_back(depth - zero);
    const std::vector<double> forces = values(depths);
    std::vector<double> all;
    std::size_t next = 0;
    for (const double depth : given)
        all.push_back(depth - zero > least * deepest ? forces[next++] : 0.);
    return all;
}

Case relaxed(Case c) {
    c.relaxation.reset();
    return c;
}

std::vector<double> measured_values(const std::string& model,
                                    const IdentificationInput::Table& table,
                                    const IdentifiedRig& identified,
                                    const std::vector<double>& given,
                                    const contact::ModelRunner& runner) {
    if (table.measurement == Measurement::friction_loop) {
        std::vector<LoopState> starts;
        return loop_forces(table, identified, starts);
    }
    const Case& rig = identified.as_case;
    if (rig.adhesion)
        return adhesive_values(
            table, identified, given,
            RigDiscs(rig, io::measurement_model(model).is_layer, RigDiscs::usual_step / 2));
    const Case slow = relaxed(rig);
    if (table.measurement == Measurement::rolling_shift)
        return rolled_shifts(
            identified, own_wobble(shift_model(model), slow, largest_offset(table.given), runner),
            given);
    const bool on_layer = io::measurement_model(model).is_layer;
    if (table.measurement == Measurement::sliding_force)
        return sliding_forces(on_layer, slow, given);
    if (table.measurement == Measurement::static_shift)
        return by_load(table, slow, given, [&](const Case& loaded, const auto& forces) {
            return !on_layer || identified.shifts_by_theory || is_beyond_coulomb(loaded)
                       ? theory_shifts(on_layer, loaded, forces)
                       : static_shifts(shift_model(model), loaded, forces, runner);
        });
    return from_zero_depth(table, identified, given, [&](const std::vector<double>& pressed_to) {
        return values_of_presses(table, rig, pressed_to,
                                 presses(model, slow, controls_of(table, rig, pressed_to), runner));
    });
}

}  // namespace tricontact::experiments
