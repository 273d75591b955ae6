#include <iterator>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
#include "experiments/identification/identification_checks.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/identification_study.h"
#include "experiments/identification/report/loop_report.h"
#include "experiments/predictions/loop_predictions.h"
#include "experiments/predictions/record_laws.h"
#include "experiments/predictions/record_predictions.h"
#include "experiments/records/experiment.h"
#include "experiments/records/experiment_report.h"
#include "io/case/rig_file.h"

namespace tricontact::app {

namespace {

/// What of the case the models compute without, or from the record instead.
std::vector<std::string> left_out_of(const Case& c,
                                     const experiments::ExperimentEvaluation& evaluation) {
    std::vector<std::string> lines;
    for (const std::string& model : c.models)
        for (const std::string& one : comparisons::left_out(c, model))
            lines.push_back(model + " leaves out " + one);
    if (c.rolling && evaluation.amplitude > 0)
        lines.emplace_back(
            "experiment leaves out rolling.amplitude and rolling.periods of the case: models roll "
            "as recorded");
    if (c.load.hold > 0 && evaluation.rolled_as.hold && *evaluation.rolled_as.hold != c.load.hold)
        lines.emplace_back(
            "experiment leaves out load.hold of the case: the rest before rolling is that of the "
            "record");
    return lines;
}

/// Before what the best law's models say.
void add_laws(report::Document& document, const experiments::RecordLaws& laws) {
    const auto verdicts = experiments::record_law_verdicts(laws);
    document.verdicts.insert(document.verdicts.begin(), verdicts.begin(), verdicts.end());
    document.sections.insert(document.sections.begin(), experiments::record_law_section(laws));
    document.settings.emplace_back("law of friction of the models",
                                   experiments::law_name(laws.tables.laws[laws.best]) + ", " +
                                       experiments::law_numbers(laws.tables.laws[laws.best]));
}

/// Loops have their values from `identify`'s own study, and models beside them.
void evaluate_loops(CommandOptions& options) {
    options.reads->emplace_back("[measurement]");
    options.reads->emplace_back("[rig]");
    const experiments::IdentificationInput input =
        experiments::read_identification(options.file, options.overrides);
    experiments::check_loop_models(input, options.file, options.overrides);
    experiments::IdentificationStudy study;
    experiments::LoopPredictions predictions;
    nlohmann::ordered_json data;
    std::vector<report::Verdict> verdicts;
    options.fill({{"experiment.json", "report.html", "loops.csv"}}, [&] {
        study = experiments::identification_study(input, false, options.runner(), options.sayer());
        study.command = "tricontact experiment " + options.file;
        for (auto& [name, line] : study.settings)
            if (line.starts_with("identify ")) line.replace(0, 8, "experiment");
        study.version = files::version;
        predictions = experiments::predict_loops(
            study, options.file, {options.runner(), options.overrides, options.sayer()});
        verdicts = experiments::loop_prediction_verdicts(study, predictions);
        data = experiments::identification_json(study);
        data["predicted_loops"] = experiments::loop_prediction_json(predictions);
        for (const auto& verdict : verdicts) data["verdicts"].push_back(verdict.sentence);
        report::Document document = experiments::identification_document(study);
        document.kind = "Experiment";
        document.lead =
            "What the recorded loops say, and what models make of the same drive with the values "
            "that these loops tell.";
        document.files.front().second = "experiment.json";
        document.verdicts.insert(document.verdicts.begin(), verdicts.begin(), verdicts.end());
        document.sections.insert(document.sections.begin(),
                                 experiments::loop_prediction_section(study, predictions));
        options.write("loops.csv", experiments::loops_csv(study));
        options.write("experiment.json", data.dump(2) + '\n');
        options.write_report(document, study.command);
    });
    Answer answer([&] { return data.dump(2); });
    for (const auto& verdict : experiments::identification_verdicts(study))
        answer.add(verdict.sentence + '\n');
    for (const auto& verdict : verdicts) answer.add(verdict.sentence + '\n');
    for (const auto& [name, line] : study.settings)
        if (name == "left out") answer.note(line + '\n');
    options.answer(answer);
    options.say(options.where());
}

void evaluate_records(CommandOptions& options) {
    options.choose_folder();
    if (experiments::has_friction_loops(options.file, options.overrides)) {
        evaluate_loops(options);
        return;
    }
    const experiments::ExperimentInput input =
        experiments::read_experiment(options.file, options.overrides);
    if (input.has_laws) options.reads->emplace_back("[measurement]");
    if (input.case_file && !input.has_laws) {
        io::read_case(*input.case_file, options.overrides).refuse_extras("predictions of records");
    }
    experiments::ExperimentEvaluation evaluation =
        experiments::evaluate_experiment(input.experiment);
    report::Document document;
    std::vector<std::string> left_out;
    nlohmann::ordered_json laws;
    options.fill({{"experiment.json", "report.html"}}, [&] {
        std::vector<std::string> overrides = options.overrides;
        std::optional<experiments::RecordLaws> compared;
        const experiments::PredictionRuns runs{options.runner(), overrides, options.sayer()};
        if (input.has_laws) {
            compared = experiments::compare_record_laws(evaluation, input, runs);
            evaluation = *compared->best_law().evaluation;
            std::ranges::copy(compared->best_law().overrides, std::back_inserter(overrides));
            laws = experiments::record_law_json(*compared);
        } else if (input.case_file) {
            experiments::add_predictions(evaluation, input, runs);
        }
        document = experiments::experiment_document(evaluation);
        if (compared) add_laws(document, *compared);
        document.files = {{"all numbers", "experiment.json"}};
        if (input.case_file)
            left_out = left_out_of(io::read_case(*input.case_file, overrides), evaluation);
        for (const std::string& line : left_out)
            document.settings.emplace_back("not computed", line);
        options.write("experiment.json",
                      experiments::experiment_json(files::version, evaluation, laws));
        options.write_report(document, "tricontact experiment " + options.file);
    });
    Answer answer([&] { return experiments::experiment_json(files::version, evaluation, laws); },
                  document.answer->sentence + '\n');
    for (const auto& verdict : document.verdicts) answer.add(verdict.sentence + '\n');
    for (const std::string& line : left_out) answer.note(line + '\n');
    options.answer(answer);
    options.say(options.where());
}

}  // namespace

Command experiment_command() {
    return Declared<CommandOptions>(Group::rigs, "experiment",
                                    "Evaluate records of a rig; compare with its models",
                                    evaluate_records)
        .on_case({"[record]", io::uncertainty_mark})
        .output("Folder (results/<case>)")
        .exports()
        .threads()
        .json()
        .quiet();
}

}  // namespace tricontact::app
