#include <iostream>
#include <optional>

#include "app/case_run.h"
#include "app/commands/commands.h"
#include "app/run_model.h"
#include "app/run_text.h"
#include "bem/case_compliance.h"
#include "comparisons/run/report.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/case/case_reader.h"
#include "io/case/case_writer.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"
#include "io/results/paraview_macro.h"

namespace tricontact::app {

namespace {

io::OutputNames run_outputs(const std::vector<std::string>& models) {
    io::OutputNames names{{resolved_case_name, "summary.json", "report.html"},
                          {io::paraview_macro_name, "plots/"}};
    for (const std::string& model : models)
        for (const std::string& name : model_results) names.results.push_back(model + '/' + name);
    return names;
}

CaseRun compute(const contact::Case& c, const RunOptions& options) {
    const std::string resolved = io::write_case(c);
    io::write_file(options.output + "/" + resolved_case_name, resolved);
    const Say say = [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    };
    CaseRun run =
        run_models(c, options, say, [&](const std::string& name, comparisons::LoadingStudy* study) {
            return run_model(name, c, resolved, options, study);
        });
    io::write_file(options.output + "/summary.json", summary_of(run));
    io::write_file(options.output + "/" + io::paraview_macro_name,
                   io::paraview_macro(options.output));
    if (options.report) {
        io::make_output_folder(options.output + "/plots");
        for (const auto& file :
             comparisons::make_report(c, resolved, files::version, run.histories, run.extras))
            io::write_file(options.output + "/" + file.name, file.content);
    }
    return run;
}

}  // namespace

void run_command(const RunOptions& given) {
    RunOptions options = given;
    const contact::Case c = io::read_case(options.case_file, options.overrides, options.models);
    refuse_rolling_on(c, options.case_file);
    bem::check_influence_file(c);  // before anything is written
    options.output = io::output_folder(options.output, options.case_file);
    io::OutputFolder folder(options.output, run_outputs(c.models));
    std::optional<CaseRun> done;
    folder.fill([&] { done.emplace(compute(c, options)); });
    const CaseRun& run = *done;
    if (!options.quiet)
        std::cout << run_text(run) << (options.report ? "report: " : "results: ") << options.output
                  << (options.report ? "/report.html\n" : "\n");
}

}  // namespace tricontact::app
