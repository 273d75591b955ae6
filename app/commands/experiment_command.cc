#include "app/commands/command.h"
#include "app/record_predictions.h"
#include "experiments/records/experiment.h"
#include "experiments/records/experiment_report.h"
#include "io/case/rig_file.h"

namespace tricontact::app {

namespace {

void evaluate_records(CommandOptions options) {
    options.choose_folder();
    const experiments::ExperimentInput input =
        experiments::read_experiment(options.file, options.overrides);
    experiments::ExperimentEvaluation evaluation =
        experiments::evaluate_experiment(input.experiment);
    report::Document document;
    options.fill({{"experiment.json", "report.html"}}, [&] {
        if (input.case_file) add_predictions(evaluation, input, options);
        document = experiments::experiment_document(evaluation);
        document.files = {{"all numbers", "experiment.json"}};
        options.write("experiment.json", experiments::experiment_json(files::version, evaluation));
        options.write_report(document, "tricontact experiment " + options.file);
    });
    options.out() << document.answer->sentence << '\n';
    for (const auto& verdict : document.verdicts) options.out() << verdict.sentence << '\n';
    options.say(options.where());
}

}  // namespace

Command experiment_command() {
    return Declared<CommandOptions>(
               "experiment", "Evaluate records of a rig; compare with its models", evaluate_records)
        .on_case({"[record]", io::uncertainty_mark})
        .output("Folder (results/<case>)")
        .exports()
        .threads()
        .quiet();
}

}  // namespace tricontact::app
