#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
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

void evaluate_records(CommandOptions options) {
    options.choose_folder();
    const experiments::ExperimentInput input =
        experiments::read_experiment(options.file, options.overrides);
    if (input.case_file)
        io::read_case(*input.case_file, options.overrides)
            .require_rigid_interface("predictions of records");
    experiments::ExperimentEvaluation evaluation =
        experiments::evaluate_experiment(input.experiment);
    report::Document document;
    std::vector<std::string> left_out;
    options.fill({{"experiment.json", "report.html"}}, [&] {
        if (input.case_file)
            experiments::add_predictions(evaluation, input,
                                         {options.runner(), options.overrides, options.sayer()});
        document = experiments::experiment_document(evaluation);
        document.files = {{"all numbers", "experiment.json"}};
        if (input.case_file)
            left_out = left_out_of(io::read_case(*input.case_file, options.overrides), evaluation);
        for (const std::string& line : left_out)
            document.settings.emplace_back("not computed", line);
        options.write("experiment.json", experiments::experiment_json(files::version, evaluation));
        options.write_report(document, "tricontact experiment " + options.file);
    });
    Answer answer([&] { return experiments::experiment_json(files::version, evaluation); },
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
