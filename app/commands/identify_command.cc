#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands/command.h"
#include "app/identification_models.h"
#include "report/format.h"

namespace tricontact::app {

namespace {

using experiments::IdentificationStudy;
using experiments::IdentificationTask;
using experiments::IdentifiedModel;
using experiments::Properties;
using experiments::Property;
using Measurement = experiments::IdentificationInput::Measurement;

constexpr int n_curve_points = 60, n_profile_points = 41, n_map_points = 41;
// Interpolated and direct model values at the best properties may differ by this, over the largest
// value; ten times what the tables are made for, where grid cells make a curve rough.
constexpr double largest_interpolation_error = 5e-3;

IdentificationTask task_of(const experiments::IdentificationInput& input) {
    IdentificationTask task;
    task.observed = input.observed;
    task.standard_errors = input.standard_errors;
    task.start = {input.rig.substrate.young, input.rig.friction_coefficient};
    task.young_is_free = input.young_is_free;
    task.friction_is_free = input.friction_is_free;
    if (input.friction_is_free)
        task.least_friction = std::ranges::max(input.given) / *input.rig.load.normal_force;
    task.confidence = input.confidence;
    return task;
}

std::vector<double> equal_steps(double from, double to, int n) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(from + (to - from) * i / (n - 1));
    return values;
}

/// Over the ranges of both profiles.
experiments::SquaresMap map_of(const IdentificationTask& task, const IdentifiedModel& model) {
    const auto range = [](const experiments::Profile& profile) {
        return equal_steps(profile.value.front(), profile.value.back(), n_map_points);
    };
    experiments::SquaresMap map{range(*model.profiles.young), range(*model.profiles.friction), {}};
    map.values = experiments::sums_of_squares(task, map.young, map.friction);
    return map;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference = std::max(difference, std::abs(a[i] - b[i]));
        largest = std::max(largest, std::abs(b[i]));
    }
    return difference / largest;
}

struct IdentifyOptions : CommandOptions {
    bool posterior = false;
};

/// One model at work on the input.
struct Identifier {
    const experiments::IdentificationInput& input_;
    int threads_;
    bool has_posterior_;
    IdentificationTask task_ = task_of(input_);

    IdentifiedModel identify(const std::string& name, const std::vector<double>& curve_points) {
        task_.model = prediction_of(name, input_, threads_);
        IdentifiedModel model;
        model.name = name;
        model.found = experiments::identify(task_);
        const Properties best = model.found.best;
        if (input_.young_is_free) task_.start.young = best.young;  // of the next model
        if (model.found.young) model.profiles.young = profile(model, Property::young);
        if (model.found.friction) model.profiles.friction = profile(model, Property::friction);
        if (model.found.young && model.found.friction) model.map = map_of(task_, model);
        if (slides(best)) return model;
        check_interpolation(model);
        model.contributions = input_contributions(name, input_, task_, best, threads_);
        if (has_posterior_) {
            std::vector<Properties> changes;
            for (const auto& one : model.contributions) changes.push_back(one.change);
            model.posterior = experiments::sample_posterior(task_, model.found, changes);
        }
        model.curve = measured_values(name, input_.measurement, rig_with(input_, best),
                                      curve_points, threads_);
        return model;
    }

    experiments::Profile profile(const IdentifiedModel& model, Property property) const {
        return experiments::profile_of(task_, model.found, property, n_profile_points);
    }

    /// The largest force is all that this mu holds: models have no state there.
    bool slides(const Properties& best) const {
        constexpr double margin = 1e-6;
        return input_.friction_is_free && best.friction < (1 + margin) * task_.least_friction;
    }

    void check_interpolation(IdentifiedModel& model) const {
        if (model.name == "half-space") return;
        const auto direct =
            measured_values(model.name, input_.measurement, rig_with(input_, model.found.best),
                            input_.given, threads_);
        model.interpolation_error = largest_difference(model.found.fitted, direct);
        if (*model.interpolation_error > largest_interpolation_error)
            throw contact::NotConverged(fmt::format(
                "{}: interpolated values are {:.1e} off the model's own, allowed {:.0e}; take a "
                "finer resolution",
                model.name, *model.interpolation_error, largest_interpolation_error));
    }
};

std::vector<std::pair<std::string, std::string>> settings_of(
    const experiments::IdentificationInput& input) {
    const Case& rig = input.rig;
    std::vector<std::pair<std::string, std::string>> settings{
        {"measurement", std::string(experiments::name_of(input.measurement))},
        {"table", std::filesystem::path(input.data_file).filename().string()},
        {"observations", std::to_string(input.observed.size())},
        {"R", report::given_quantity(rig.indenter.radius, "m")},
        {"nu", report::as_given(rig.substrate.poisson)}};
    if (rig.layer.thickness)
        settings.emplace_back("b", report::given_quantity(*rig.layer.thickness, "m"));
    if (input.measurement == Measurement::static_shift)
        settings.emplace_back("F_N", report::given_quantity(*rig.load.normal_force, "N"));
    if (!input.young_is_free)
        settings.emplace_back("E", report::given_quantity(rig.substrate.young, "Pa"));
    if (!input.friction_is_free && input.measurement == Measurement::static_shift)
        settings.emplace_back("mu", report::as_given(rig.friction_coefficient));
    return settings;
}

IdentificationStudy study_of(const experiments::IdentificationInput& input,
                             const IdentifyOptions& options) {
    IdentificationStudy study;
    study.input = input;
    study.title =
        input.title.empty() ? std::filesystem::path(input.name).stem().string() : input.title;
    const double largest = std::ranges::max(input.given);
    study.curve_points = equal_steps(largest / n_curve_points, largest, n_curve_points);
    study.settings = settings_of(input);
    study.command = "tricontact identify " + std::filesystem::path(input.name).filename().string();
    study.version = files::version;
    Identifier identifier{input, options.threads, options.posterior};
    for (const std::string& name : input.models) {
        options.say(name);
        study.models.push_back(identifier.identify(name, study.curve_points));
    }
    if (input.rig.layer.thickness) {
        const Case rig = rig_with(input, reference_model(study).found.best);
        study.thickness_ratio =
            *rig.layer.thickness / (2 * contact::half_space_scales(rig).contact_radius);
    }
    return study;
}

void print(const IdentificationStudy& study) {
    std::cout << fmt::format("{:<11} {:<32} {:<26} {:>8}  {}\n", "model", "E", "mu", "R^2",
                             "residuals");
    for (const IdentifiedModel& model : study.models) {
        const auto& found = model.found;
        std::cout << fmt::format(
            "{:<11} {:<32} {:<26} {:>8.5f}  {}\n", model.name,
            found.young ? experiments::shown(model, experiments::Property::young) : "given",
            found.friction ? experiments::shown(model, experiments::Property::friction) : "given",
            found.r_squared,
            found.goodness
                ? fmt::format("chi^2 = {:.3g}, {} degrees of freedom", found.sum_of_squares,
                              found.degrees_of_freedom)
                : report::quantity(found.residual_standard_deviation,
                                   std::string(columns_of(study.input.measurement).observed.unit),
                                   2));
    }
    for (const IdentifiedModel& model : study.models)
        if (model.posterior) std::cout << experiments::posterior_sentence(model) << '\n';
    for (const auto& verdict : experiments::identification_verdicts(study))
        std::cout << verdict.sentence << '\n';
}

void identify_properties(IdentifyOptions options) {
    const experiments::IdentificationInput input =
        experiments::read_identification(options.file, options.overrides);
    options.choose_folder();
    IdentificationStudy study;
    options.fill({{"identify.json", "report.html", "posterior.csv"}}, [&] {
        study = study_of(input, options);
        if (options.posterior) options.write("posterior.csv", experiments::posterior_csv(study));
        options.write("identify.json", experiments::identification_json(study).dump(2) + '\n');
        options.write_report(experiments::identification_document(study), study.command);
    });
    print(study);
}

}  // namespace

Command identify_command() {
    return Declared<IdentifyOptions>("identify", "Find E and mu from a measurement on a rig",
                                     identify_properties)
        .on_case()
        .flag("--posterior", &IdentifyOptions::posterior,
              "Draw from the posterior density of E, mu and the uncertain inputs (posterior.csv)")
        .output("Folder (results/<case>)")
        .threads()
        .quiet("No progress");
}

}  // namespace tricontact::app
