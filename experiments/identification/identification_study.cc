#include "experiments/identification/identification_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "contact/base/error.h"
#include "experiments/identification/adhesion_parameter.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/identification_models.h"
#include "experiments/identification/interface_parameters.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/row_weights.h"
#include "io/case/measurement_models.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using contact::Case;
using Measurement = IdentificationInput::Measurement;

constexpr int n_curve_points = 60;
// Of a profile, and of a map along each axis; with three parameters and more fewer, each of which
// takes a search.
constexpr int n_points = 41, n_points_of_many = 21;
// Interpolated and direct model values at the best values may differ by this, over the largest
// of a table; ten times what the tables are made for, where grid cells make a curve rough.
constexpr double largest_interpolation_error = 5e-3;

std::vector<double> equal_steps(double from, double to, int n) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(from + (to - from) * i / (n - 1));
    return values;
}

/// Where the curves of a table are drawn: times at equal ratios.
std::vector<double> curve_points_of(const IdentificationInput::Table& table) {
    if (!table.loops.loops.empty()) return table.given;
    if (!table.normal_forces.empty()) return table.given;  // a curve under each load: by the rows
    const auto [least, largest] = std::ranges::minmax(table.given);
    if (table.measurement == Measurement::rolling_shift || table.is_adhesive)
        return equal_steps(least, largest, n_curve_points);
    if (!table.is_history()) return equal_steps(largest / n_curve_points, largest, n_curve_points);
    auto points = equal_steps(std::log(least), std::log(largest), n_curve_points);
    for (double& point : points) point = std::exp(point);
    return points;
}

/// One model at work on the input.
struct Identifier {
    const IdentificationInput& input_;
    const contact::ModelRunner& runner_;
    bool draws_posterior_;
    const std::vector<std::vector<double>>& curve_points_;
    IdentificationTask task_ = {};

    IdentifiedModel model_called(const std::string& name) {
        task_ = task_of(input_, name);
        task_.model = prediction_of(name, input_, runner_);
        IdentifiedModel model;
        model.name = name;
        model.found = identify(task_);
        draw(model);
        if (slides(model.found)) return model;
        const IdentifiedRig rig = rig_with(input_, model.found.free, model.found.best());
        check_interpolation(model, rig);
        model.contributions = input_contributions(name, input_, task_, model.found, runner_);
        model.correlations = input_.correlations;
        if (draws_posterior_) {
            const auto changes = independent_changes(model);
            model.posterior = sample_posterior(task_, model.found, changes);
        }
        for (std::size_t t = 0; t < input_.tables.size(); ++t) {
            model.curves.push_back(
                measured_values(name, input_.tables[t], rig, curve_points_[t], runner_));
            for (double& value : model.curves[t]) value += model.found.tables[t].origin;
        }
        return model;
    }

    /// What independent normal numbers do to the parameters in place of the correlated inputs.
    static std::vector<std::vector<double>> independent_changes(const IdentifiedModel& model) {
        std::vector<std::string> keys;
        for (const auto& one : model.contributions) keys.push_back(one.key);
        const auto root = statistics::triangular_root(model.correlations.of(keys), keys.size());
        std::vector<std::vector<double>> changes(
            keys.size(), std::vector<double>(model.found.parameters.size(), 0.));
        for (std::size_t i = 0; i < keys.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j)
                for (std::size_t k = 0; k < changes[j].size(); ++k)
                    changes[j][k] += root[i][j] * model.contributions[i].change[k];
        return changes;
    }

    /// Profiles and maps.
    void draw(IdentifiedModel& model) const {
        const std::size_t m = task_.parameters.size();
        const int n = m > 2 ? n_points_of_many : n_points;
        for (std::size_t k = 0; k < m; ++k)
            model.profiles.push_back(profile_of(task_, model.found, k, n));
        const auto range = [&](std::size_t k) {
            const auto& values = model.profiles[k].value;
            return equal_steps(values.front(), values.back(), n);
        };
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t k = i + 1; k < m; ++k) {
                SquaresMap map{i, k, range(i), range(k), {}};
                map.values = squares_of_pair(task_, model.found, i, k, map.x, map.y);
                model.maps.push_back(std::move(map));
            }
    }

    /// The largest force is all that this mu holds: models have no state there.
    bool slides(const Identification& found) const {
        constexpr double margin = 1e-6;
        const auto k = found.find("friction.coefficient");
        return k && input_.rig.friction.is_coulomb() &&
               found.parameters[*k].value < (1 + margin) * found.free[*k].low;
    }

    void check_interpolation(IdentifiedModel& model, const IdentifiedRig& rig) const {
        if (!io::measurement_model(model.name).is_layer) return;
        double error = 0;
        for (std::size_t t = 0; t < input_.tables.size(); ++t) {
            const auto& [origin, fitted] =
                std::tie(model.found.tables[t].origin, model.found.tables[t].fitted);
            const auto direct =
                measured_values(model.name, input_.tables[t], rig, input_.tables[t].given, runner_);
            double largest = 0;
            for (const double value : direct) largest = std::max(largest, std::abs(value));
            // Of shifts that follow the drive, what the pivot does: own wobble may take it back.
            if (input_.tables[t].measurement == Measurement::rolling_shift)
                largest =
                    std::max(largest, largest_offset(input_.tables[t].given) *
                                          std::abs(rig.pivot_height) / rig.as_case.indenter.radius);
            for (std::size_t i = 0; i < direct.size(); ++i)
                error = std::max(error, std::abs(fitted[i] - origin - direct[i]) / largest);
        }
        model.interpolation_error = error;
        if (error > largest_interpolation_error)
            throw contact::NotConverged(fmt::format(
                "{}: interpolated values are {:.1e} off the model's own, allowed {:.0e}; take a "
                "finer resolution",
                model.name, error, largest_interpolation_error));
    }
};

/// The law of friction with its numbers, of the found ones their symbols.
std::string law_text(const IdentificationInput& input) {
    const contact::Friction& friction = input.rig.friction;
    const auto is_found = [](const FreeParameter& p) { return is_of_law(p.key); };
    if (std::ranges::none_of(input.parameters, is_found) && input.laws.empty())
        return friction.formula();
    const auto shown = [&](std::string_view key, const char* symbol, double value,
                           const std::string& unit) {
        const bool is_free = input.is_free(key) || !input.laws.empty();
        return is_free        ? std::string(symbol)
               : unit.empty() ? report::as_given(value)
                              : report::given_quantity(value, unit);
    };
    std::string text;
    if (friction.shear_strength)
        text = shown(strength_key, "tau_0", *friction.shear_strength, "Pa");
    if (friction.coefficient)
        text += (text.empty() ? "" : " + ") +
                shown(coefficient_key, "mu", *friction.coefficient, "") +
                (friction.pressure_exponent
                     ? " p_r (p/p_r)^" + shown(exponent_key, "n", *friction.pressure_exponent, "")
                     : " p");
    if (friction.strength_limit)
        text = "min(" + text + ", " +
               shown(strength_limit_key, "tau_cap", *friction.strength_limit, "Pa") + ")";
    if (friction.reference_pressure)
        text += ", p_r = " + report::given_quantity(*friction.reference_pressure, "Pa");
    return text;
}

/// A half-space that finds mu alone is laid beside one with a strength.
std::vector<std::string> laws_to_compare(const IdentificationInput& input) {
    if (!input.laws.empty()) return input.laws;
    const bool has_half_space =
        !std::ranges::all_of(input.models, &io::MeasurementModel::is_layer, io::measurement_model);
    if (input.find(Measurement::friction_loop)) return {};
    if (!has_half_space || !input.is_free(coefficient_key) || !input.rig.friction.is_coulomb())
        return {};
    return {"coulomb", "shear-strength"};
}

/// The input without its coefficient of friction, where laws bring their own.
IdentificationInput without_friction(IdentificationInput input, const std::string& model) {
    input.parameters = parameters_of(input, model);
    std::erase_if(input.parameters,
                  [](const FreeParameter& p) { return p.key == "friction.coefficient"; });
    return input;
}

/// The most complete model, all of which know laws and springs where these are asked for.
std::string model_of_laws(const IdentificationInput& input) {
    const auto layer =
        std::ranges::find_if(input.models, &io::MeasurementModel::is_layer, io::measurement_model);
    return layer != input.models.end() ? *layer : half_space_model();
}

std::optional<LawComparison> compared_laws(const IdentificationInput& input,
                                           const contact::ModelRunner& runner,
                                           const contact::Say& say) {
    const auto laws = laws_to_compare(input);
    if (laws.empty()) return {};
    say("laws of friction");
    try {
        const std::string model = input.laws.empty() ? half_space_model() : model_of_laws(input);
        return compare_laws(without_friction(input, model), laws, runner, model);
    } catch (const contact::NotConverged&) {
        if (!input.laws.empty()) throw;
        return {};  // nobody asked, and the models will say what is wrong with Coulomb's law
    }
}

std::vector<std::pair<std::string, std::string>> settings_of(const IdentificationInput& input) {
    const Case& rig = input.rig;
    std::vector<std::pair<std::string, std::string>> settings;
    for (const std::string& line : left_out_lines(input)) settings.emplace_back("left out", line);
    for (const auto& table : input.tables)
        settings.emplace_back(
            name_of(table),
            fmt::format("{}, {} observations{}",
                        std::filesystem::path(table.data_file).filename().string(),
                        table.observed.size(), table.reading.empty() ? "" : "; " + table.reading));
    const auto add = [&](const char* key, const char* symbol, const std::string& value) {
        if (!input.is_free(key)) settings.emplace_back(symbol, value);
    };
    add("indenter.radius", "R", report::given_quantity(rig.indenter.radius, "m"));
    add("substrate.poisson", "nu", report::as_given(rig.substrate.poisson));
    if (rig.layer.thickness)
        add("substrate.thickness", "b", report::given_quantity(*rig.layer.thickness, "m"));
    add("substrate.young", "E", report::given_quantity(rig.substrate.young, "Pa"));
    if (rig.interface.normal_stiffness)
        add(normal_stiffness_key, "k_n",
            report::given_quantity(*rig.interface.normal_stiffness, "Pa/m"));
    if (rig.interface.tangential_stiffness)
        add(tangential_stiffness_key, "k_t",
            report::given_quantity(*rig.interface.tangential_stiffness, "Pa/m"));
    if (input.rig.adhesion)
        add("adhesion.work", "w", report::given_quantity(input.rig.adhesion->work, "J/m2"));
    if (input.rig.adhesion && input.rig.adhesion->approach_work)
        add(approach_key.data(), "w_a",
            report::given_quantity(*input.rig.adhesion->approach_work, "J/m2"));
    if (input.rig.adhesion && !input.rig.adhesion->is_short_ranged())
        add("adhesion.range", "h_0", report::given_quantity(input.rig.adhesion->distance(), "m"));
    if (!input.find(Measurement::static_shift) && !input.find(Measurement::rolling_shift))
        return settings;
    const auto* shifts = input.find(Measurement::static_shift);  // all of them state loads or none
    if (!shifts || shifts->normal_forces.empty())
        settings.emplace_back("F_N", report::given_quantity(*rig.load.normal_force, "N"));
    if (!rig.friction.is_coulomb()) {
        settings.emplace_back("tau", law_text(input));
        return settings;
    }
    add("friction.coefficient", "mu", report::as_given(rig.friction_coefficient()));
    return settings;
}

}  // namespace

IdentificationStudy identification_study(const IdentificationInput& said, bool draws_posterior,
                                         const contact::ModelRunner& runner,
                                         const contact::Say& say) {
    IdentificationStudy study;
    study.input = said;
    study.laws = compared_laws(said, runner, say);
    if (!said.laws.empty()) study.input = study.laws->laws[study.laws->best].input;
    weigh_rows(study.input, runner);
    const IdentificationInput& input = study.input;
    if (std::ranges::any_of(input.parameters,
                            [](const FreeParameter& p) { return is_of_interface(p.key); })) {
        say("interface");
        const std::string model = model_of_laws(input);
        IdentificationInput of_model = input;
        of_model.parameters = parameters_of(input, model);
        study.interfaces = compare_interfaces(of_model, runner, model);
    }
    study.title =
        input.title.empty() ? std::filesystem::path(input.name).stem().string() : input.title;
    for (const auto& table : input.tables) study.curve_points.push_back(curve_points_of(table));
    study.settings = settings_of(input);
    Identifier identifier{input, runner, draws_posterior, study.curve_points};
    for (const std::string& name : input.models) {
        say(name);
        study.models.push_back(identifier.model_called(name));
    }
    if (const auto half_space = half_space_of(study); half_space != study.models.end())
        study.ranges = excluded_ranges(input, half_space->name, half_space->found, runner);
    if (input.find(Measurement::friction_loop)) {
        say("loops");
        const IdentifiedModel& reference = reference_model(study);
        IdentificationTask task = task_of(input, reference.name);
        task.model = prediction_of(reference.name, input, runner);
        study.loops = loop_findings(input, task, reference.found);
    }
    if (input.rig.layer.thickness) {
        const auto& found = reference_model(study).found;
        const Case rig = rig_with(input, found.free, found.best()).as_case;
        study.thickness_ratio =
            *rig.layer.thickness / (2 * contact::half_space_scales(rig).contact_radius);
    }
    return study;
}

}  // namespace tricontact::experiments
