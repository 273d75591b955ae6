#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "app/case_run.h"
#include "app/commands.h"
#include "app/run_model.h"
#include "bem/case_compliance.h"
#include "comparisons/report.h"
#include "contact/error.h"
#include "io/atomic_file.h"
#include "io/case_reader.h"
#include "io/case_writer.h"
#include "io/paraview_macro.h"

namespace tricontact::app {

namespace {

contact::Case read(const RunOptions& options) {
    std::vector<std::string> overrides = options.overrides;
    if (!options.models.empty())
        overrides.push_back(fmt::format("models=[\"{}\"]", fmt::join(options.models, "\", \"")));
    return io::read_case(options.case_file, overrides);
}

/// Results of an earlier run must not stand beside a new case as if they were its own.
void remove_old_results(const std::string& output, const std::vector<std::string>& models) {
    std::error_code ignored;  // a file that cannot be removed cannot be written either: said then
    for (const char* name : {"summary.json", "report.html"})
        std::filesystem::remove(output + "/" + name, ignored);
    for (const std::string& model : models)
        for (const char* name : {"history.csv", "surface.pvd", "volume.pvd"})
            std::filesystem::remove(output + "/" + model + "/" + name, ignored);
}

}  // namespace

void run_command(const RunOptions& given) {
    RunOptions options = given;
    const contact::Case c = read(options);
    refuse_rolling_on(c, options.case_file);
    bem::check_influence_file(c);  // before anything is written
    if (options.output.empty())
        options.output = "results/" + std::filesystem::path(options.case_file).stem().string();
    io::make_output_folder(options.output);

    remove_old_results(options.output, c.models);

    const std::string resolved = io::write_case(c);
    io::write_file(options.output + "/" + resolved_case_name, resolved);
    const Say say = [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    };
    const CaseRun run =
        run_models(c, options, say, [&](const std::string& name, comparisons::LoadingStudy* study) {
            return run_model(name, c, resolved, options, study);
        });
    io::write_file(options.output + "/summary.json", summary_of(run));
    io::write_file(options.output + "/" + io::paraview_macro_name,
                   std::string(io::paraview_macro()));
    if (options.report) {
        io::make_output_folder(options.output + "/plots");
        for (const auto& file :
             comparisons::make_report(c, resolved, TRICONTACT_VERSION, run.histories, run.extras))
            io::write_file(options.output + "/" + file.name, file.content);
    }
    if (!options.quiet)
        std::cerr << "results in " << options.output
                  << (options.report ? " (open report.html)" : "") << '\n';
}

}  // namespace tricontact::app
