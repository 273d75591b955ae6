#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands.h"
#include "app/models.h"
#include "comparisons/report.h"
#include "comparisons/summary.h"
#include "contact/error.h"
#include "contact/run.h"
#include "io/atomic_file.h"
#include "io/case_reader.h"
#include "io/case_writer.h"
#include "io/history_csv.h"
#include "io/progress.h"
#include "io/vtk_series.h"

namespace tricontact::app {

namespace {

const std::string version = TRICONTACT_VERSION;
const std::string resolved_name = "case.toml";

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
        for (const char* name : {"history.csv", "surface.pvd"})
            std::filesystem::remove(output + "/" + model + "/" + name, ignored);
}

bool wants_vtk(contact::Case::VtkOutput choice, const contact::Progress& progress) {
    using enum contact::Case::VtkOutput;
    return choice == all || (choice == quarters && progress.quarter);
}

/// One model: its steps with progress, its history and its surfaces in a folder of its own.
contact::History run_model(const std::string& name, const contact::Case& c,
                           const RunOptions& options) {
    const std::string folder = options.output + "/" + name;
    io::make_output_folder(folder);
    // The command that makes the file again from what stands beside the results.
    io::VtkSeries series(folder, "surface", {version, "tricontact run " + resolved_name});
    io::ProgressBar bar(std::cerr, io::ProgressBar::style_of_stderr(options.quiet), name);

    auto model = make_model(name, c, options.threads, [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    });
    const contact::Observer observer = [&](const contact::StepRecord& record,
                                           const contact::Model& state,
                                           const contact::Progress& progress) {
        bar.update(progress.step, progress.steps_at_most);
        if (wants_vtk(c.output.vtk, progress)) series.add(record.phase, state.surface());
    };
    contact::History history;
    try {
        history = contact::run(c, *model, observer);
    } catch (const contact::NotConverged&) {
        if (c.output.vtk != contact::Case::VtkOutput::none) series.finish();  // what did converge
        throw;
    }
    bar.finish(c.rolling ? contact::name_of(history.state) : "");

    io::write_file(folder + "/history.csv", io::history_csv(history));
    if (c.output.vtk != contact::Case::VtkOutput::none) series.finish();
    return history;
}

nlohmann::ordered_json as_json(const std::string& toml_text) {
    std::ostringstream text;
    const toml::table table = toml::parse(toml_text);
    text << toml::json_formatter{table};
    return nlohmann::ordered_json::parse(text.str());
}

}  // namespace

void run_command(const RunOptions& given) {
    RunOptions options = given;
    const contact::Case c = read(options);
    if (options.output.empty())
        options.output = "results/" + std::filesystem::path(options.case_file).stem().string();
    io::make_output_folder(options.output);

    remove_old_results(options.output, c.models);

    const std::string resolved = io::write_case(c);
    io::write_file(options.output + "/" + resolved_name, resolved);
    std::vector<contact::History> histories;
    std::vector<comparisons::ModelSummary> summaries;
    for (const std::string& name : c.models) {
        histories.push_back(run_model(name, c, options));
        summaries.push_back(comparisons::summarise(c, histories.back()));
    }
    io::write_file(options.output + "/summary.json",
                   comparisons::summary_json(version, as_json(resolved), summaries));
    if (options.report) {
        io::make_output_folder(options.output + "/plots");
        for (const auto& file : comparisons::make_report(c, resolved, version, histories))
            io::write_file(options.output + "/" + file.name, file.content);
    }
    if (!options.quiet)
        std::cerr << "results in " << options.output
                  << (options.report ? " (open report.html)" : "") << '\n';
}

}  // namespace tricontact::app
