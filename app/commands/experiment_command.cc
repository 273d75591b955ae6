#include "app/case_run.h"
#include "app/commands/command.h"
#include "app/uncertain_case.h"
#include "experiments/records/experiment.h"
#include "experiments/records/experiment_report.h"

namespace tricontact::app {

namespace {

using experiments::CaseQuantity;
using experiments::Experiment;
using experiments::ExperimentEvaluation;

// Of a limit run: by turning points the rig's layer needs 30.
constexpr int enough_limit_periods = 40;

/// Cells, elements and springs of twice the size; meshes that a file gives stay.
Case with_coarser_mesh(Case c) {
    for (auto* size : {&c.bem.spacing, &c.fem.size, &c.fem.accuracy})
        if (*size) **size *= 2;
    if (c.bem.cells_per_radius) *c.bem.cells_per_radius /= 2;
    c.mdr.springs /= 2;
    return c;
}

/// The models of the case, rolled as the rig rolled.
struct Predictions {
    const experiments::ExperimentInput& input_;
    const CommandOptions& options_;
    ExperimentEvaluation& evaluation_;

    void add() {
        rest_as_recorded();
        const auto& stage = evaluation_.runs.front().stages.front();
        const Case c = case_with(evaluation_.amplitude, stage.period, evaluation_.periods, true);
        if (!contact::is_hertz_round(c))
            throw contact::InputError(*input_.case_file +
                                      ": indenter.shape: records are compared with the formulas of "
                                      "a sphere; give that, or a paraboloid");
        if (c.load.is_by_limit())
            throw contact::InputError(
                fmt::format("{}: {}: the rig sets a force; give load.tangential_force",
                            *input_.case_file, c.load.limit_key()));
        const auto hertz = contact::half_space_scales(c);
        const double amplitude = contact::path_amplitude(c, hertz.contact_radius);
        for (const io::UncertainKey& one : input_.uncertain)
            evaluation_.uncertain_numbers.emplace_back(one.key->path);
        evaluation_.correlation = input_.correlations.of(evaluation_.uncertain_numbers);
        experiments::normalise(
            evaluation_, c,
            uncertain_case(c, hertz.normal_force, amplitude, input_.uncertain).quantities);
        for (const std::string& model : c.models)
            if (evaluation_.kind == Experiment::Kind::limit)
                add_states(model);
            else
                add_shift(model, c);
    }

    /// On a relaxing substrate the rest under F_T and the drive's speed are those of the record.
    void rest_as_recorded() {
        const Case c = io::read_case(*input_.case_file, options_.overrides);
        if (!c.relaxation) return;
        const experiments::Rest& rest = evaluation_.rest;
        experiments::RolledAs& as = evaluation_.rolled_as;
        const bool case_knows = c.load.hold > 0 && c.load.hold >= rest.time;
        as.hold_is_known = rest.is_whole || case_knows;
        as.hold = !rest.is_whole && case_knows ? c.load.hold : rest.time;
    }

    Case case_with(double amplitude, double period, int periods, bool run_all) const {
        std::vector<std::string> overrides = options_.overrides;
        overrides.push_back(fmt::format("rolling.periods={}", periods));
        overrides.push_back(fmt::format("rolling.run_all={}", run_all));
        if (amplitude > 0) overrides.push_back(fmt::format("rolling.amplitude={} m", amplitude));
        const auto& hold = evaluation_.rolled_as.hold;
        if (hold) overrides.push_back(fmt::format("load.hold={} s", *hold));
        Case c = io::read_case(*input_.case_file, overrides);
        if (!hold) return c;
        if (amplitude == 0)
            amplitude = contact::rolling_amplitude(*c.rolling,
                                                   contact::half_space_scales(c).contact_radius);
        c.rolling->speed = 4 * amplitude / period;
        evaluation_.rolled_as.speed = c.rolling->speed;
        return c;
    }

    contact::History run(const std::string& name, const Case& c) const {
        return history_of(name, c, options_.threads, silent);
    }

    static std::vector<double> shift_of(const contact::History& history) {
        std::vector<double> shift{history.static_shift};
        shift.insert(shift.end(), history.shift_per_period.begin(), history.shift_per_period.end());
        return shift;
    }
    void add_shift(const std::string& name, const Case& c) {
        options_.say(fmt::format("{}: {} periods", name, evaluation_.periods));
        const contact::History history = run(name, c);
        experiments::ModelPrediction prediction{name,
                                                shift_of(history),
                                                history.verdict.state,
                                                experiments::model_wobble(c, history),
                                                {}};
        const UncertainCase uncertain =
            uncertain_case(c, history.friction_limit / c.friction_coefficient, history.amplitude,
                           input_.uncertain);
        for (const CaseQuantity& quantity : uncertain.quantities)
            prediction.raised.push_back(raised(name, uncertain.set, quantity, prediction.shift));
        if (!prediction.raised.empty()) {
            options_.say(name + ": once more on a mesh of twice the size");
            prediction.coarser = shift_of(run(name, with_coarser_mesh(c)));
        }
        experiments::add_prediction(evaluation_, std::move(prediction));
    }

    /// The shift with a number larger by its error; where it cannot be, mirrored from a smaller
    /// one.
    std::vector<double> raised(const std::string& name, const Case& set,
                               const CaseQuantity& quantity,
                               const std::vector<double>& unchanged) const {
        options_.say(fmt::format("{}: once more, {} larger by its error", name, quantity.name));
        Case other = set;
        double& number = quantity.of_case(other);
        const bool larger = number + quantity.standard_error <= quantity.largest;
        number += larger ? quantity.standard_error : -quantity.standard_error;
        std::vector<double> shift = shift_of(run(name, other));
        for (std::size_t n = 0; n < shift.size() && !larger; ++n)
            shift[n] = 2 * unchanged[n] - shift[n];
        return shift;
    }

    void add_states(const std::string& name) {
        experiments::PredictedLimit limit{name, {}};
        for (const auto& stage : evaluation_.runs.front().stages) {
            options_.say(fmt::format("{}: W = {:.4g} mm", name, 1e3 * stage.amplitude));
            const Case c = case_with(stage.amplitude, stage.period, enough_limit_periods, false);
            limit.states.push_back(run(name, c).verdict.state);
        }
        evaluation_.model_limits.push_back(std::move(limit));
    }
};

void evaluate_records(CommandOptions options) {
    options.choose_folder();
    const experiments::ExperimentInput input =
        experiments::read_experiment(options.file, options.overrides);
    ExperimentEvaluation evaluation = experiments::evaluate_experiment(input.experiment);
    report::Document document;
    options.fill({{"experiment.json", "report.html"}}, [&] {
        if (input.case_file) Predictions{input, options, evaluation}.add();
        document = experiments::experiment_document(evaluation);
        document.files = {{"all numbers", "experiment.json"}};
        options.write("experiment.json", experiments::experiment_json(files::version, evaluation));
        options.write_report(document, "tricontact experiment " + options.file);
    });
    for (const auto& verdict : document.verdicts) std::cout << verdict.sentence << '\n';
    options.say(options.where());
}

}  // namespace

Command experiment_command() {
    return Declared<CommandOptions>(
               "experiment", "Evaluate records of a rig; compare with its models", evaluate_records)
        .on_case()
        .output("Folder (results/<case>)")
        .threads()
        .quiet();
}

}  // namespace tricontact::app
