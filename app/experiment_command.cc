#include <fmt/format.h>

#include <iostream>

#include "app/case_run.h"
#include "app/commands.h"
#include "comparisons/experiment_report.h"
#include "contact/error.h"
#include "io/atomic_file.h"
#include "io/case_reader.h"
#include "io/experiment_reader.h"

namespace tricontact::app {

namespace {

using comparisons::CaseQuantity;
using comparisons::ExperimentEvaluation;
using contact::Case;
using contact::Experiment;

constexpr int enough_periods = 40;  // of a limit run: by turning points the rig's layer needs 30

// The number of the case that a key stands for; null where the case states another one instead.
double* number_of(const io::CaseKey& key, Case& c) {
    const io::Field field = key.field(c);
    if (auto* const* value = std::get_if<double*>(&field)) return *value;
    if (auto* const* value = std::get_if<std::optional<double>*>(&field))
        return *value && **value ? &***value : nullptr;
    return nullptr;
}

std::vector<CaseQuantity> quantities_of(const io::ExperimentInput& input, Case& c) {
    std::vector<CaseQuantity> quantities;
    for (const auto& error : input.errors) {
        const io::CaseKey& key = *error.key;
        if (!number_of(key, c))
            throw contact::InputError(fmt::format(
                "{}: errors.{}: the case does not state this number; name the key that it has",
                error.place, key.path));
        quantities.push_back({std::string(key.path), error.standard_error,
                              [&key](Case& any) -> double& { return *number_of(key, any); }});
    }
    return quantities;
}

/// The models of the case, rolled as the rig rolled.
class Predictions {
  public:
    Predictions(const io::ExperimentInput& input, const ExperimentOptions& options,
                ExperimentEvaluation& evaluation)
        : input_(input), options_(options), evaluation_(evaluation) {}

    void add() {
        Case c = case_with(evaluation_.amplitude, evaluation_.periods, true);
        if (!contact::is_hertz_round(c))
            throw contact::InputError(*input_.case_file +
                                      ": indenter.shape: records are compared with the formulas of "
                                      "a sphere; give that, or a paraboloid");
        const auto quantities = quantities_of(input_, c);
        comparisons::normalise(evaluation_, c, quantities);
        for (const std::string& model : c.models)
            if (evaluation_.kind == Experiment::Kind::limit)
                add_states(model);
            else
                add_shift(model, c, quantities);
    }

  private:
    Case case_with(double amplitude, int periods, bool run_all) const {
        std::vector<std::string> overrides{fmt::format("rolling.periods={}", periods),
                                           fmt::format("rolling.run_all={}", run_all)};
        if (amplitude > 0) overrides.push_back(fmt::format("rolling.amplitude={} m", amplitude));
        return io::read_case(*input_.case_file, overrides);
    }

    contact::History run(const std::string& name, const Case& c) const {
        return history_of(name, c, options_.threads, [](const std::string&) {});
    }
    void say(const std::string& line) const {
        if (!options_.quiet) std::cerr << line << '\n';
    }

    static std::vector<double> shift_of(const contact::History& history) {
        std::vector<double> shift{history.static_shift};
        shift.insert(shift.end(), history.shift_per_period.begin(), history.shift_per_period.end());
        return shift;
    }
    void add_shift(const std::string& name, const Case& c,
                   const std::vector<CaseQuantity>& quantities) {
        say(fmt::format("{}: {} periods", name, evaluation_.periods));
        const contact::History history = run(name, c);
        comparisons::ModelPrediction prediction{
            name, shift_of(history), history.state, comparisons::model_wobble(c, history), {}};
        for (const CaseQuantity& quantity : quantities) {
            say(fmt::format("{}: once more, {} larger by its error", name, quantity.name));
            Case raised = c;
            quantity.of_case(raised) += quantity.standard_error;
            prediction.raised.push_back(shift_of(run(name, raised)));
        }
        comparisons::add_prediction(evaluation_, std::move(prediction));
    }
    void add_states(const std::string& name) {
        comparisons::ModelLimit limit{name, {}};
        for (const auto& stage : evaluation_.runs.front().stages) {
            say(fmt::format("{}: W = {:.4g} mm", name, 1e3 * stage.amplitude));
            limit.states.push_back(
                run(name, case_with(stage.amplitude, enough_periods, false)).state);
        }
        evaluation_.model_limits.push_back(std::move(limit));
    }

    const io::ExperimentInput& input_;
    const ExperimentOptions& options_;
    ExperimentEvaluation& evaluation_;
};

}  // namespace

void experiment_command(const ExperimentOptions& given) {
    ExperimentOptions options = given;
    options.output = io::output_folder(options.output, options.data_file);
    const io::ExperimentInput input = io::read_experiment(options.data_file);
    ExperimentEvaluation evaluation = comparisons::evaluate_experiment(input.experiment);
    if (input.case_file) Predictions(input, options, evaluation).add();

    io::make_output_folder(options.output);
    comparisons::Document document = comparisons::experiment_document(evaluation);
    document.version = TRICONTACT_VERSION;
    document.command = "tricontact experiment " + options.data_file;
    document.files = {{"all numbers", "experiment.json"}};
    io::write_file(options.output + "/experiment.json",
                   comparisons::experiment_json(document.version, evaluation));
    io::write_file(options.output + "/report.html", comparisons::document_html(document));
    for (const auto& verdict : document.verdicts) std::cout << verdict.sentence << '\n';
    if (!options.quiet) std::cerr << "results in " << options.output << " (open report.html)\n";
}

}  // namespace tricontact::app
