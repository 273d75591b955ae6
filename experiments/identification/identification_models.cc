#include "experiments/identification/identification_models.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <variant>

#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/adhesive_values.h"
#include "experiments/identification/friction_values.h"
#include "experiments/identification/identification_tables.h"
#include "experiments/identification/layer_contact.h"
#include "experiments/identification/loop_values.h"
#include "io/case/case_keys.h"
#include "io/case/measurement_models.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using Measurement = IdentificationInput::Measurement;

// A layer's compliance that much above the indenter's: this is rigid, to 1e-3.
constexpr double rigid_ratio = 1e-3;
/// Whether results of the rig depend on R and b by their proportion to E alone.
bool is_scaled(const Case& rig) {
    const bool is_rigid =
        !rig.indenter.material ||
        rig.indenter.material->plane_compliance() < rigid_ratio * rig.substrate.plane_compliance();
    return is_rigid && rig.layer.thickness && rig.layer.lower.empty() &&
           rig.layer.base != Case::Base::half_space && !rig.layer.width && !rig.layer.depth &&
           !rig.period && rig.indenter.shape == Case::Shape::paraboloid && !rig.indenter.roughness;
}

using TableModel = std::function<std::vector<double>(const IdentifiedRig&)>;

/// Own wobble and that of the pivot, which is nothing but a slope.
TableModel rolling_model(const std::string& model, const IdentificationInput& input,
                         const IdentificationInput::Table& table,
                         const contact::ModelRunner& runner) {
    const Case rig = relaxed(input.rig);
    if (!is_coupled(shift_model(model), rig, runner))
        return [&table](const IdentifiedRig& at) { return rolled_shifts(at, 0, table.given); };
    std::vector<double> forces;  // that bound mu where it is free
    if (input.is_free("friction.coefficient"))
        for (const auto* shifts : input.all(Measurement::static_shift))
            forces.insert(forces.end(), shifts->given.begin(), shifts->given.end());
    const auto own = std::make_shared<WobbleTable>(shift_model(model), rig,
                                                   largest_offset(table.given), forces, runner);
    return [own, &table](const IdentifiedRig& at) {
        return rolled_shifts(at, own->at(at.as_case), table.given);
    };
}

/// Interpolated, under each of the table's loads.
TableModel shift_table_model(const std::string& model, const IdentificationInput& input,
                             const IdentificationInput::Table& table,
                             const contact::ModelRunner& runner) {
    const Case rig = relaxed(input.rig);
    std::map<double, std::shared_ptr<ShiftTable>> shifts;
    for (const LoadedRows& load : rows_by_load(table, rig, table.given)) {
        Case loaded = rig;
        loaded.load.normal_force = load.normal_force;
        shifts[load.normal_force] = std::make_shared<ShiftTable>(
            shift_model(model), loaded, load.given, input.shifts_by_theory, runner);
    }
    return [shifts, &table](const IdentifiedRig& at) {
        return by_load(table, at.as_case, table.given, [&](const Case& loaded, const auto&) {
            return shifts.at(*loaded.load.normal_force)->at(loaded);
        });
    };
}

TableModel table_model(const std::string& model, const IdentificationInput& input,
                       const IdentificationInput::Table& table,
                       const std::shared_ptr<PressTable>& presses_of,
                       const contact::ModelRunner& runner) {
    if (input.rig.adhesion)
        return [&table,
                discs = std::make_shared<RigDiscs>(
                    input.rig, io::measurement_model(model).is_layer)](const IdentifiedRig& rig) {
            return adhesive_values(table, rig, table.given, *discs);
        };
    const bool is_mapped =
        io::measurement_model(model).kind().is_read() && input.is_free("substrate.poisson");
    const bool is_sheared = table.measurement == Measurement::static_shift;
    if (table.measurement == Measurement::rolling_shift)
        return rolling_model(model, input, table, runner);
    if (table.measurement == Measurement::sliding_force)
        return
            [&table, on_layer = io::measurement_model(model).is_layer](const IdentifiedRig& rig) {
                return sliding_forces(on_layer, rig.as_case, table.given);
            };
    if (table.measurement == Measurement::friction_loop)
        return [&table, starts = std::make_shared<std::vector<LoopState>>()](
                   const IdentifiedRig& rig) { return loop_forces(table, rig, *starts); };
    const bool is_direct = is_sheared ? is_mapped || is_beyond_coulomb(input.rig)
                                      : !presses_of || input.rig.interface.normal_stiffness;
    if (!io::measurement_model(model).is_layer || is_direct)
        return [=, &table](const IdentifiedRig& rig) {
            return measured_values(model, table, rig, table.given, runner);
        };
    if (is_sheared) return shift_table_model(model, input, table, runner);
    return [=, &table](const IdentifiedRig& rig) {
        const Case& c = rig.as_case;
        return from_zero_depth(table, rig, table.given, [&](const std::vector<double>& given) {
            std::vector<Pressed> all;
            for (const auto& control : controls_of(table, c, given))
                all.push_back(presses_of->at(c, control));
            return values_of_presses(table, c, given, all);
        });
    };
}

/// Terms of a Prony series, over the unrelaxed modulus.
void set_term(contact::Relaxation& relaxation, const FreeParameter& p, double value,
              std::vector<double>& relative) {
    if (p.key == "substrate.relaxation.times")
        relaxation.branches[p.index].time = value;
    else
        relative[p.index] = value;
}

/// Errors of a model's own shifts as two inputs.
std::vector<InputContribution> own_contributions(const std::string& model,
                                                 const IdentificationInput& input,
                                                 const IdentificationTask& task,
                                                 const Identification& found, const Case& rig,
                                                 const std::vector<double>& observed) {
    // Of all rows; of other tables none.
    std::vector<double> errors, forces;
    std::vector<std::size_t> rows;
    std::size_t row = 0;
    for (const auto& table : input.tables) {
        if (table.measurement == Measurement::static_shift) {
            const auto own = by_load(table, relaxed(rig), table.given,
                                     [&](const Case& loaded, const auto& given) {
                                         return static_shift_errors(model, loaded, given);
                                     });
            errors.insert(errors.end(), own.begin(), own.end());
            forces.insert(forces.end(), table.given.begin(), table.given.end());
            for (std::size_t i = 0; i < own.size(); ++i) rows.push_back(row + i);
        }
        row += table.observed.size();
    }
    if (errors.empty()) return {};
    const auto [least, largest] = std::ranges::minmax(forces);
    std::vector<InputContribution> contributions;
    for (const bool alike : {true, false}) {
        std::vector<double> moved = observed;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double place =
                largest > least ? (2 * forces[i] - least - largest) / (largest - least) : 0;
            // Mean squares of 1, of forces that are evenly spread.
            const double pattern = alike ? 1 : std::sqrt(3.) * place;
            moved[rows[i]] -= pattern * errors[i] / std::sqrt(2.);
        }
        std::vector<double> change = best_nearby(task, found, moved);
        for (std::size_t k = 0; k < change.size(); ++k) change[k] -= found.parameters[k].value;
        contributions.push_back({alike ? "atlas" : "atlas.curve",
                                 std::ranges::max(errors) / std::sqrt(2.), std::move(change)});
    }
    return contributions;
}

/// What neighbours of a table are neighbours in. A period of rolling passes each offset twice:
/// neighbours are those in time. Of several loads one follows the other: places in that order.
std::vector<double> order_of(const IdentificationInput::Table& table) {
    if (table.has_free_origin() || !table.loops.loops.empty()) return {};
    if (table.normal_forces.empty()) return table.given;
    std::map<std::pair<double, double>, double> places;
    for (std::size_t row = 0; row < table.given.size(); ++row)
        places[{table.normal_forces[row], table.given[row]}] = 0;
    double place = 0;
    for (auto& one : places) one.second = place++;
    std::vector<double> order;
    for (std::size_t row = 0; row < table.given.size(); ++row)
        order.push_back(places[{table.normal_forces[row], table.given[row]}]);
    return order;
}

}  // namespace

void check_lengths_scale(const IdentificationInput& input) {
    if (!input.is_free("indenter.radius") && !input.is_free("substrate.thickness")) return;
    for (const std::string& model : input.models)
        if (io::measurement_model(model).is_layer && !is_scaled(input.rig))
            throw contact::InputError(
                "measurement.find: " + model +
                " finds radius and thickness only of a rigid paraboloid on one layer on a rigid "
                "base; find the modulus and friction, or take the model half-space");
}

IdentificationTask task_of(const IdentificationInput& input, const std::string& model) {
    IdentificationTask task{.parameters = parameters_of(input, model),
                            .confidence = input.confidence};
    for (const auto& table : input.tables)
        task.tables.push_back({name_of(table), table.observed, table.standard_errors,
                               table.has_free_origin(), order_of(table), table.row_errors.relative,
                               table.row_errors.parts, n_of_loop * table.loops.loops.size()});
    if (input.find(Measurement::friction_loop))
        task.inner_slopes = [&input, parameters = task.parameters](const auto& values) {
            const IdentifiedRig rig = rig_with(input, parameters, values);
            std::vector<std::vector<double>> columns;
            std::size_t n_rows = 0, row = 0;
            for (const auto& table : input.tables) n_rows += table.observed.size();
            for (const auto& table : input.tables) {
                for (const auto& slopes : loop_slopes(table, rig)) {
                    auto& column = columns.emplace_back(n_rows, 0.);
                    std::ranges::copy(slopes, column.begin() + static_cast<std::ptrdiff_t>(row));
                }
                row += table.observed.size();
            }
            return columns;
        };
    return task;
}

Prediction prediction_of(const std::string& model, const IdentificationInput& input,
                         const contact::ModelRunner& runner) {
    std::shared_ptr<PressTable> presses_of;
    if (is_scaled(input.rig) && io::measurement_model(model).is_layer)
        presses_of = std::make_shared<PressTable>(model, relaxed(input.rig),
                                                  input.is_free("substrate.poisson"), runner);
    std::vector<TableModel> tables;
    for (const auto& table : input.tables)
        tables.push_back(table_model(model, input, table, presses_of, runner));
    return [tables, &input,
            parameters = parameters_of(input, model)](const std::vector<double>& values) {
        const IdentifiedRig rig = rig_with(input, parameters, values);
        std::vector<double> all;
        for (const TableModel& table : tables)
            std::ranges::copy(table(rig), std::back_inserter(all));
        return all;
    };
}

IdentifiedRig rig_with(const IdentificationInput& input,
                       const std::vector<FreeParameter>& parameters,
                       const std::vector<double>& values) {
    IdentifiedRig rig{.as_case = input.rig,
                      .shifts_by_theory = input.shifts_by_theory,
                      .rig_compliance = input.rig_compliance,
                      .loops_on_layer = has_loops_on_layer(input)};
    rig.zero_depths.assign(input.all(Measurement::force_indentation).size(), 0);
    Case& c = rig.as_case;
    std::optional<double> approach_share;
    std::vector<double> relative;
    if (c.relaxation)
        for (const auto& branch : c.relaxation->branches)
            relative.push_back(branch.ratio / c.relaxation->instantaneous_ratio());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const FreeParameter& p = parameters[k];
        if (p.key.starts_with("substrate.relaxation."))
            set_term(*c.relaxation, p, values[k], relative);
        else if (p.key == pivot_key)
            rig.pivot_height = values[k];
        else if (p.key == rig_stiffness_key)
            rig.rig_compliance = 1 / values[k];
        else if (p.key == drift_key)
            rig.friction_drift = values[k];
        else if (p.key == zero_depth_key)
            rig.zero_depths.at(p.index) = values[k];
        else if (p.key == approach_key)
            approach_share = values[k];
        else
            *io::number_of(*io::find_key(p.key), c) = values[k];
    }
    if (approach_share) c.adhesion->approach_work = *approach_share * c.adhesion->work;
    double relaxed_share = 1, last_time = 0;
    for (const double share : relative) relaxed_share -= share;
    if (!(relaxed_share > 0))
        throw contact::InputError("relative moduli: nothing would be left at rest");
    for (std::size_t i = 0; i < relative.size(); ++i) {
        auto& branch = c.relaxation->branches[i];
        branch.ratio = relative[i] / relaxed_share;
        // Terms keep their order: exchanged they are the same series.
        const bool was_later = i == 0 || input.rig.relaxation->branches[i].time >
                                             input.rig.relaxation->branches[i - 1].time;
        if (i > 0 && was_later != (branch.time > last_time))
            throw contact::InputError("relaxation times: exchanged");
        last_time = branch.time;
    }
    return rig;
}

std::vector<double> values_of_tables(const std::string& model, const IdentificationInput& input,
                                     const IdentifiedRig& rig, const contact::ModelRunner& runner) {
    std::vector<double> all;
    for (const auto& table : input.tables)
        std::ranges::copy(measured_values(model, table, rig, table.given, runner),
                          std::back_inserter(all));
    return all;
}

std::vector<InputContribution> input_contributions(const std::string& model,
                                                   const IdentificationInput& input,
                                                   const IdentificationTask& task,
                                                   const Identification& found,
                                                   const contact::ModelRunner& runner) {
    const IdentifiedRig rig = rig_with(input, found.free, found.best());
    const auto values_at = [&](const io::CaseKey& key, double change) {
        IdentifiedRig other = rig;
        *io::number_of(key, other.as_case) += change;
        return values_of_tables(model, input, other, runner);
    };
    std::vector<double> observed;
    for (const auto& table : input.tables)
        std::ranges::copy(table.observed, std::back_inserter(observed));
    const std::vector<double> unchanged = values_of_tables(model, input, rig, runner);
    std::vector<InputContribution> contributions;
    for (const auto& [key, error] : input.rig_errors) {
        std::vector<double> changed, moved = observed;
        double sign = 1;
        try {
            changed = values_at(*key, error);
        } catch (const contact::InputError&) {  // as at nu = 1/2, which ends there
            sign = -1;
            changed = values_at(*key, -error);
        }
        for (std::size_t i = 0; i < changed.size(); ++i)
            moved[i] -= sign * (changed[i] - unchanged[i]);
        std::vector<double> change = best_nearby(task, found, moved);
        for (std::size_t k = 0; k < change.size(); ++k) change[k] -= found.parameters[k].value;
        contributions.push_back({std::string(key->path), error, std::move(change)});
    }
    for (auto& own : own_contributions(model, input, task, found, rig.as_case, observed))
        contributions.push_back(std::move(own));
    return contributions;
}

}  // namespace tricontact::experiments
