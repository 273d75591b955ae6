#include <fmt/format.h>

#include <iostream>

#include "app/commands/command.h"
#include "app/roll_models.h"
#include "app/studies/study_kind.h"
#include "comparisons/half_space/deviation_output.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/case/case_reader.h"
#include "io/results/result_store.h"

namespace tricontact::app {

namespace {

using comparisons::HalfSpaceDeviation;
using comparisons::RolledResult;
using comparisons::RolledRun;

struct DeviationOptions : CommandOptions {
    bool runs = true;  ///< of boundary elements; else exact theory alone
};

/// Refuses a case without deviations, with the place of the file, before anything is removed.
void check_contact(const DeviationOptions& options, const contact::Case& c) {
    try {
        comparisons::deviation_contact(c);
    } catch (const contact::InputError& error) {
        throw contact::InputError(options.file + ": " + error.what());
    }
}

std::vector<RolledRun> runs_of(const HalfSpaceDeviation& deviation) {
    std::vector<RolledRun> runs;
    for (const auto& body : comparisons::rolled_bodies(deviation))
        for (const RolledRun& run : comparisons::runs_on(body, deviation.amplitudes))
            runs.push_back(run);
    return runs;
}

StudyPoint point_of(const HalfSpaceDeviation& deviation, const RolledRun& run,
                    const std::string& name) {
    const contact::Case c =
        comparisons::rolled_case(deviation.c, deviation.contact, deviation.amplitudes, run);
    // Whatever the user's case passes, that of a run is checked by itself.
    const contact::Case checked = io::parse_case(io::write_case(c), name);
    return make_point(checked, checked.models.front(), run.level, name);
}

void add_runs(const DeviationOptions& options, HalfSpaceDeviation& deviation) {
    const std::vector<RolledRun> runs = runs_of(deviation);
    if (runs.empty()) return;
    std::vector<StudyPoint> points;
    for (const RolledRun& run : runs) points.push_back(point_of(deviation, run, options.file));
    io::ResultStore store = open_results(options.output);
    compute_missing(contact_kind(), points, store,
                    {.name = "deviation", .jobs = options.threads, .quiet = options.quiet});
    std::vector<RolledResult> results;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto outcome = store.find(points[i].key);
        results.push_back({runs[i], outcome && outcome->results
                                        ? std::optional(results_of(*outcome))
                                        : std::nullopt});
    }
    comparisons::add_rolled(results, deviation);
}

std::string command_of(const DeviationOptions& options) {
    std::string command = "tricontact deviation " + options.file;
    for (const std::string& text : options.overrides) command += fmt::format(" --set \"{}\"", text);
    return command + (options.runs ? "" : " --no-runs");
}

void write(const DeviationOptions& options, const contact::Case& c,
           const HalfSpaceDeviation& deviation) {
    options.write("deviation.csv", deviation_csv(deviation));
    options.write("deviation.json", deviation_json(files::version, io::write_case(c), deviation));
    options.write_report(deviation_document(deviation), command_of(options));
}

/// How far the layer of a case is from a half-space: deviation.json, deviation.csv, the report, and
/// a table on standard output. Finished runs of an earlier call are taken over.
void compare_with_half_space(DeviationOptions options) {
    options.choose_folder("_deviation");
    const contact::Case c = io::read_case(options.file, options.overrides);
    refuse_rolling_on(c, options.file);
    check_contact(options, c);
    HalfSpaceDeviation deviation;
    options.fill({{"deviation.csv", "deviation.json", "report.html"}, io::result_store_files()},
                 [&] {
                     deviation = comparisons::exact_deviation(c);
                     if (options.runs) add_runs(options, deviation);
                     write(options, c, deviation);
                 });
    std::cout << deviation_text(deviation);
    for (const auto& verdict : deviation_verdicts(deviation)) std::cout << verdict.sentence << '\n';
    options.say(options.where());
}

}  // namespace

Command deviation_command() {
    return Declared<DeviationOptions>("deviation",
                                      "How far the layer of a case is from a half-space",
                                      compare_with_half_space)
        .on_case()
        .jobs()
        .output("Folder (results/<case>_deviation)")
        .flag("--no-runs", &DeviationOptions::runs, "Exact theory alone: no friction, no rolling",
              false)
        .quiet();
}

}  // namespace tricontact::app
