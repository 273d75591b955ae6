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

using experiments::Properties;
using report::LazyTable;
using Measurement = experiments::IdentificationInput::Measurement;

// Steps of tables, for 1e-5 of the values: they are nearly powers of E, and coupling with friction
// changes them by a few percent at most.
constexpr double log_young_step = 0.2;
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
                 log_young_step, 1, {0, is_coupled() ? last_row : 0}) {}

    ShiftTable(const ShiftTable&) = delete;  // its table calls it back
    ShiftTable& operator=(const ShiftTable&) = delete;

    std::vector<double> at(const Properties& p) {
        const double friction = std::min(p.friction, most_);
        const double row = last_row * (1 / (1 + least_) - 1 / (1 + friction)) / z_range();
        const auto logs = table_.at(std::log(p.young), row);
        const boost::math::barycentric_rational<double> curve(places_.data(), logs.data(),
                                                              places_.size(), curve_order);
        std::vector<double> shifts;
        for (const double force : forces_) {
            const double f = std::min(1., force / (p.friction * *rig_.load.normal_force));
            shifts.push_back(p.friction * f * std::exp(curve(std::cbrt(1 - f))));
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

}  // namespace

double* number_of(const io::CaseKey& key, Case& c) {
    const io::Field field = io::place_of(key, c);
    if (auto* const* value = std::get_if<double*>(&field)) return *value;
    if (auto* const* value = std::get_if<std::optional<double>*>(&field))
        return *value && **value ? &***value : nullptr;
    return nullptr;
}

experiments::Prediction prediction_of(const std::string& model,
                                      const experiments::IdentificationInput& input, int threads) {
    const auto direct = [model, &input, threads](const Properties& p) {
        return measured_values(model, input.measurement, rig_with(input, p), input.given, threads);
    };
    if (model == "half-space") return direct;
    if (input.measurement == Measurement::static_shift) {
        const auto table =
            std::make_shared<ShiftTable>(shift_model(model), input.rig, input.given, threads);
        return [table](const Properties& p) { return table->at(p); };
    }
    const double friction = input.rig.friction_coefficient;  // does not matter
    const auto node = [=](double x, double) { return logarithms(direct({std::exp(x), friction})); };
    const auto table = std::make_shared<LazyTable>(node, log_young_step, 1., LazyTable::Rows{0, 0});
    return [table](const Properties& p) {
        auto values = table->at(std::log(p.young), 0);
        for (double& value : values) value = std::exp(value);
        return values;
    };
}

Case rig_with(const experiments::IdentificationInput& input, const Properties& properties) {
    Case c = input.rig;
    c.substrate.young = properties.young;
    c.friction_coefficient = properties.friction;
    return c;
}

std::vector<experiments::InputContribution> input_contributions(
    const std::string& model, const experiments::IdentificationInput& input,
    const experiments::IdentificationTask& task, const Properties& best, int threads) {
    const Case rig = rig_with(input, best);
    const auto values = [&](const Case& c) {
        return measured_values(model, input.measurement, c, input.given, threads);
    };
    const auto values_at = [&](const io::CaseKey& key, double change) {
        Case c = rig;
        *number_of(key, c) += change;
        return values(c);
    };
    const std::vector<double> unchanged = values(rig);
    std::vector<experiments::InputContribution> contributions;
    for (const auto& [key, error] : input.rig_errors) {
        std::vector<double> changed;
        double sign = 1;
        try {
            changed = values_at(*key, error);
        } catch (const contact::InputError&) {  // as at nu = 1/2, which ends there
            sign = -1;
            changed = values_at(*key, -error);
        }
        experiments::IdentificationTask moved = task;
        for (std::size_t i = 0; i < changed.size(); ++i)
            moved.observed[i] -= sign * (changed[i] - unchanged[i]);
        const Properties found = experiments::identify(moved).best;
        contributions.push_back({std::string(key->path),
                                 error,
                                 {found.young - best.young, found.friction - best.friction}});
    }
    return contributions;
}

}  // namespace tricontact::app
