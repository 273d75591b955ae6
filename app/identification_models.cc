#include "app/identification_models.h"

#include <algorithm>
#include <boost/math/interpolators/barycentric_rational.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <variant>

#include "app/models.h"
#include "report/lazy_table.h"

namespace tricontact::app {

namespace {

using experiments::FreeParameter;
using report::LazyTable;
using Measurement = experiments::IdentificationInput::Measurement;

// A layer's compliance that much above the indenter's: this is rigid, to 1e-3.
constexpr double rigid_ratio = 1e-3;
// Of Poisson's ratio, where a table has rows of it, from 0 to 1/2.
constexpr double poisson_step = 0.025;
constexpr int last_poisson_row = 20;
// Steps of tables, for 1e-5 of the values: they are nearly powers of E, and coupling with friction
// changes them by a few percent at most.
constexpr double log_step = 0.2;
// Of z = 1/(1 + mu), for what mu changes by coupling: from the largest F_T/F_N, which holds, to a
// few times that, where hardly anything slips; beyond it coupling stays as it is there.
constexpr int last_row = 3;
constexpr double most_over_least = 3, most_at_least = 1;
// Places on a curve of shifts over the force, in s = (1 - f_T)^(1/3), Cattaneo's stick radius, in
// which it is smooth up to sliding. The last grid cells that stick make it rough.
constexpr int n_sampled_points = 9;
constexpr double least_stick_radius = 0.25;
constexpr int curve_order = 5;

std::vector<double> curve_points() {
    std::vector<double> s;  // Chebyshev's, increasing
    for (int j = n_sampled_points - 1; j >= 0; --j) {
        const double t = std::cos((2 * j + 1) * std::numbers::pi / (2 * n_sampled_points));
        s.push_back((1 + least_stick_radius) / 2 + (1 - least_stick_radius) / 2 * t);
    }
    return s;
}

std::vector<double> logarithms(std::vector<double> values) {
    for (double& value : values) value = std::log(value);
    return values;
}

/// The curve of shifts: U/(mu f_T) at all places, from which U follows for any force.
class ShiftTable {
  public:
    ShiftTable(std::string model, const Case& rig, std::vector<double> forces, int threads)
        : model_(std::move(model)),
          rig_(rig),
          forces_(std::move(forces)),
          threads_(threads),
          places_(curve_points()),
          least_(*std::ranges::max_element(forces_) / *rig_.load.normal_force),
          most_(std::max(most_over_least * least_, most_at_least)),
          table_([this](double x, double row) { return node(std::exp(x), friction_at(row)); },
                 log_step, 1, {0, is_coupled() ? last_row : 0}) {}

    ShiftTable(const ShiftTable&) = delete;  // its table calls it back
    ShiftTable& operator=(const ShiftTable&) = delete;

    std::vector<double> at(const Case& c) {
        const double mu = c.friction_coefficient, friction = std::min(mu, most_);
        const double row = last_row * (1 / (1 + least_) - 1 / (1 + friction)) / z_range();
        // The modulus that loads the layer of the table as much, and its heights.
        const double radius = c.indenter.radius / rig_.indenter.radius,
                     thickness = *c.layer.thickness / *rig_.layer.thickness;
        const double young = c.substrate.young * std::pow(thickness, 3) / radius;
        const auto logs = table_.at(std::log(young), row);
        const boost::math::barycentric_rational<double> curve(places_.data(), logs.data(),
                                                              places_.size(), curve_order);
        const double unit = thickness * thickness / radius;
        std::vector<double> shifts;
        for (const double force : forces_) {
            const double f = std::min(1., force / (mu * *rig_.load.normal_force));
            shifts.push_back(unit * mu * f * std::exp(curve(std::cbrt(1 - f))));
        }
        return shifts;
    }

  private:
    double z_range() const { return 1 / (1 + least_) - 1 / (1 + most_); }
    double friction_at(double row) const {
        return 1 / (1 / (1 + least_) - row / last_row * z_range()) - 1;
    }
    // Without coupling all shifts go with mu, so that one value of it does.
    bool is_coupled() const {
        return model_ == "atlas" || make_model(model_, rig_, threads_, silent)->is_coupled();
    }

    std::vector<double> node(double young, double friction) const {
        Case c = rig_;
        c.substrate.young = young;
        c.friction_coefficient = friction;
        std::vector<double> forces;
        for (const double s : places_)
            forces.push_back((1 - s * s * s) * friction * *c.load.normal_force);
        auto shifts = static_shifts(model_, c, forces, threads_);
        for (std::size_t j = 0; j < shifts.size(); ++j)
            shifts[j] *= *c.load.normal_force / forces[j];
        return logarithms(std::move(shifts));
    }

    std::string model_;
    Case rig_;
    std::vector<double> forces_;
    int threads_;
    std::vector<double> places_;
    double least_, most_;  // mu
    LazyTable table_;
};

/// Frictionless contact of a rigid paraboloid with a layer, over b^2/R of the depth or over
/// E b^3/R of the force.
class PressTable {
  public:
    PressTable(std::string model, const Case& rig, bool has_poisson, int threads)
        : model_(std::move(model)),
          rig_(rig),
          threads_(threads),
          has_poisson_(has_poisson),
          by_depth_(node(contact::NormalControl::Kind::indentation), log_step, 1, rows()),
          by_force_(node(contact::NormalControl::Kind::force), log_step, 1, rows()) {}

    PressTable(const PressTable&) = delete;  // its tables call it back
    PressTable& operator=(const PressTable&) = delete;

    Pressed at(const Case& c, const contact::NormalControl& control) {
        const bool is_depth = control.kind == contact::NormalControl::Kind::indentation;
        const double row = has_poisson_ ? c.substrate.poisson / poisson_step : 0;
        const auto logs = (is_depth ? by_depth_ : by_force_)
                              .at(std::log(control.value / unit_of(c, control.kind)), row);
        return {std::exp(logs[0]) * unit_of(c, contact::NormalControl::Kind::force),
                std::exp(logs[1]) * *c.layer.thickness,
                std::exp(logs[2]) * unit_of(c, contact::NormalControl::Kind::indentation)};
    }

  private:
    static double unit_of(const Case& c, contact::NormalControl::Kind kind) {
        const double b = *c.layer.thickness, depth = b * b / c.indenter.radius;
        return kind == contact::NormalControl::Kind::indentation ? depth
                                                                 : c.substrate.young * b * depth;
    }
    LazyTable::Rows rows() const { return {0, has_poisson_ ? last_poisson_row : 0}; }
    report::TableNode node(contact::NormalControl::Kind kind) {
        return [this, kind](double x, double row) {
            Case c = rig_;
            if (has_poisson_) c.substrate.poisson = std::min(.5, row * poisson_step);
            const auto press =
                presses(model_, c, {{kind, std::exp(x) * unit_of(c, kind)}}, threads_).front();
            return logarithms(
                {press.normal_force / unit_of(c, contact::NormalControl::Kind::force),
                 press.contact_radius / *c.layer.thickness,
                 press.indentation / unit_of(c, contact::NormalControl::Kind::indentation)});
        };
    }

    std::string model_;
    Case rig_;
    int threads_;
    bool has_poisson_;
    LazyTable by_depth_, by_force_;
};

/// Whether results of the rig depend on R and b by their proportion to E alone.
bool is_scaled(const Case& rig) {
    const bool is_rigid =
        !rig.indenter.material ||
        rig.indenter.material->plane_compliance() < rigid_ratio * rig.substrate.plane_compliance();
    return is_rigid && rig.layer.thickness && rig.layer.lower.empty() &&
           rig.layer.base != Case::Base::half_space && !rig.layer.width && !rig.layer.depth &&
           rig.indenter.shape == Case::Shape::paraboloid && !rig.indenter.roughness;
}

using TableModel = std::function<std::vector<double>(const Case&)>;

TableModel table_model(const std::string& model, const experiments::IdentificationInput& input,
                       const experiments::IdentificationInput::Table& table,
                       const std::shared_ptr<PressTable>& presses_of, int threads) {
    const bool is_mapped = model == "atlas" && input.is_free("substrate.poisson");
    const bool is_sheared = table.measurement == Measurement::static_shift;
    if (model == "half-space" || (is_sheared ? is_mapped : !presses_of))
        return [=, &table](const Case& c) {
            return measured_values(model, table, c, table.given, threads);
        };
    if (is_sheared) {
        const auto shifts = std::make_shared<ShiftTable>(shift_model(model), relaxed(input.rig),
                                                         table.given, threads);
        return [shifts](const Case& c) { return shifts->at(c); };
    }
    return [=, &table](const Case& c) {
        std::vector<Pressed> all;
        for (const auto& control : controls_of(table, c, table.given))
            all.push_back(presses_of->at(c, control));
        return values_of_presses(table, c, table.given, all);
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

}  // namespace

double* number_of(const io::CaseKey& key, Case& c) {
    const io::Field field = io::place_of(key, c);
    if (auto* const* value = std::get_if<double*>(&field)) return *value;
    if (auto* const* value = std::get_if<std::optional<double>*>(&field))
        return *value && **value ? &***value : nullptr;
    return nullptr;
}

void check_lengths_scale(const experiments::IdentificationInput& input) {
    if (!input.is_free("indenter.radius") && !input.is_free("substrate.thickness")) return;
    for (const std::string& model : input.models)
        if (model != "half-space" && !is_scaled(input.rig))
            throw contact::InputError(
                "measurement.find: " + model +
                " finds radius and thickness only of a rigid paraboloid on one layer on a rigid "
                "base; find the modulus and friction, or take the model half-space");
}

experiments::Prediction prediction_of(const std::string& model,
                                      const experiments::IdentificationInput& input, int threads) {
    std::shared_ptr<PressTable> presses_of;
    if (is_scaled(input.rig) && model != "half-space")
        presses_of = std::make_shared<PressTable>(model, relaxed(input.rig),
                                                  input.is_free("substrate.poisson"), threads);
    std::vector<TableModel> tables;
    for (const auto& table : input.tables)
        tables.push_back(table_model(model, input, table, presses_of, threads));
    return [tables, &input,
            parameters = parameters_of(input, model)](const std::vector<double>& values) {
        const Case c = rig_with(input, parameters, values);
        std::vector<double> all;
        for (const TableModel& table : tables) std::ranges::copy(table(c), std::back_inserter(all));
        return all;
    };
}

Case rig_with(const experiments::IdentificationInput& input,
              const std::vector<FreeParameter>& parameters, const std::vector<double>& values) {
    Case c = input.rig;
    std::vector<double> relative;
    if (c.relaxation)
        for (const auto& branch : c.relaxation->branches)
            relative.push_back(branch.ratio / c.relaxation->instantaneous_ratio());
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const FreeParameter& p = parameters[k];
        if (p.key.starts_with("substrate.relaxation."))
            set_term(*c.relaxation, p, values[k], relative);
        else
            *number_of(*io::find_key(p.key), c) = values[k];
    }
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
    return c;
}

std::vector<double> values_of_tables(const std::string& model,
                                     const experiments::IdentificationInput& input, const Case& rig,
                                     int threads) {
    std::vector<double> all;
    for (const auto& table : input.tables)
        std::ranges::copy(measured_values(model, table, rig, table.given, threads),
                          std::back_inserter(all));
    return all;
}

std::vector<experiments::InputContribution> input_contributions(
    const std::string& model, const experiments::IdentificationInput& input,
    const experiments::IdentificationTask& task, const experiments::Identification& found,
    int threads) {
    const Case rig = rig_with(input, found.free, found.best());
    const auto values_at = [&](const io::CaseKey& key, double change) {
        Case c = rig;
        *number_of(key, c) += change;
        return values_of_tables(model, input, c, threads);
    };
    std::vector<double> observed;
    for (const auto& table : input.tables)
        std::ranges::copy(table.observed, std::back_inserter(observed));
    const std::vector<double> unchanged = values_of_tables(model, input, rig, threads);
    std::vector<experiments::InputContribution> contributions;
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
        std::vector<double> change = experiments::best_nearby(task, found, moved);
        for (std::size_t k = 0; k < change.size(); ++k) change[k] -= found.parameters[k].value;
        contributions.push_back({std::string(key->path), error, std::move(change)});
    }
    return contributions;
}

}  // namespace tricontact::app
