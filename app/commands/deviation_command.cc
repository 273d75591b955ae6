#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/strain_deviation.h"
#include "comparisons/bodies/size_output.h"
#include "comparisons/finite_strain/strain_runs.h"
#include "comparisons/half_space/deviation_output.h"
#include "comparisons/quantities/left_out.h"
#include "contact/models/model_kind.h"
#include "io/case/rolling_on.h"
#include "report/table_text.h"
#include "studies/deviation_runs.h"

namespace tricontact::app {

namespace {

using comparisons::HalfSpaceDeviation;
using comparisons::RolledResult;
using comparisons::RolledRun;
using comparisons::SizeContact;
using comparisons::SizeDeviation;

struct DeviationOptions : CommandOptions {
    bool runs = true;  ///< of boundary elements; else exact theory alone
    bool finite_strain = false, body = false;
    double elements = comparisons::StrainContact{}.elements;
};

void add_runs(const DeviationOptions& options, HalfSpaceDeviation& deviation) {
    std::vector<RolledRun> runs;
    for (const auto& body : comparisons::rolled_bodies(deviation))
        for (const RolledRun& run : comparisons::runs_on(body, deviation.amplitudes))
            runs.push_back(run);
    if (runs.empty()) return;
    std::vector<studies::StudyPoint> points;
    for (const RolledRun& run : runs) {
        const Case c =
            comparisons::rolled_case(deviation.c, deviation.contact, deviation.amplitudes, run);
        points.push_back(studies::deviation_point(c, run.level, options.file));
    }
    const auto found = studies::deviation_results(options, points);
    std::vector<RolledResult> results;
    for (std::size_t i = 0; i < runs.size(); ++i) results.push_back({runs[i], found[i]});
    comparisons::add_rolled(results, deviation);
}

void write(const DeviationOptions& options, const Case& c, const HalfSpaceDeviation& deviation) {
    options.write("deviation.csv", deviation_csv(deviation));
    options.write("deviation.json", deviation_json(files::version, io::write_case(c), deviation));
    options.write_report(deviation_document(deviation),
                         studies::deviation_command(options) + (options.runs ? "" : " --no-runs"));
}

/// How far the layer of a case is from a half-space: deviation.json, deviation.csv, the report, and
/// a table on standard output. Finished runs of an earlier call are taken over.
void compare_with_half_space(DeviationOptions options) {
    options.choose_folder("_deviation");
    const Case c = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(c, options.file);
    // Before anything is removed.
    options.told_of_file([&] { return comparisons::deviation_contact(c); });
    HalfSpaceDeviation deviation;
    options.fill({{"deviation.csv", "deviation.json", "report.html"}, io::result_store_files()},
                 [&] {
                     deviation = comparisons::exact_deviation(c);
                     if (options.runs) add_runs(options, deviation);
                     write(options, c, deviation);
                 });
    Answer answer([&] { return deviation_json(files::version, io::write_case(c), deviation); },
                  report::table_text(deviation_table(deviation)));
    answer.note(comparisons::left_out_lines(c, {contact::models::bem_layer}));
    for (const auto& verdict : deviation_verdicts(deviation)) answer.add(verdict.sentence + '\n');
    options.answer(answer);
    options.say(options.where());
}

SizeDeviation sizes_computed(const CommandOptions& options, const SizeContact& contact) {
    studies::StudyPoints points;
    for (const comparisons::SizeRun& run : comparisons::size_runs(contact))
        points.push_back(
            studies::deviation_point(comparisons::size_case(contact, run), 0, options.file));
    return comparisons::size_deviation(contact, studies::deviation_results(options, points));
}

/// How large the body of a case's indenter has to be to press as a half-space does:
/// body_size.json, body_size.csv, the report, and a table on standard output. Finished runs of an
/// earlier call are taken over.
void compare_body_sizes(CommandOptions options) {
    options.choose_folder("_body_size");
    const Case c = io::read_case(options.file, options.overrides);
    io::refuse_rolling_on(c, options.file);
    // Before anything is removed.
    const SizeContact contact = options.told_of_file([&] { return comparisons::size_contact(c); });
    if (!options.makers->has(contact.model()))
        options.refuse(std::string("--body: this program was built without the model ") +
                       contact.model());
    SizeDeviation deviation;
    const auto json = [&] { return size_json(files::version, io::write_case(c), deviation); };
    options.fill({{"body_size.csv", "body_size.json", "report.html"}, io::result_store_files()},
                 [&] {
                     deviation = sizes_computed(options, contact);
                     options.write("body_size.csv", size_csv(deviation));
                     options.write("body_size.json", json());
                     options.write_report(size_document(deviation),
                                          studies::deviation_command(options) + " --body");
                 });
    Answer answer(json, report::table_text(size_table(deviation)));
    answer.note(comparisons::left_out_lines(c, {contact.model()}));
    answer.note(
        "sizes are compared under pressing alone: friction, F_T and rolling are left out\n");
    for (const auto& verdict : size_verdicts(deviation)) answer.add(verdict.sentence + '\n');
    options.answer(answer);
    options.say(options.where());
}

void compare(const DeviationOptions& options) {
    if (options.body && (options.finite_strain || !options.runs))
        throw contact::InputError(
            "--body: goes neither with --finite-strain nor with --no-runs, since sizes are known "
            "from runs alone; drop the other option");
    if (options.body) return compare_body_sizes(options);
    if (!options.finite_strain) return compare_with_half_space(options);
    if (!options.runs)
        throw contact::InputError(
            "--no-runs: what finite strains change is known from runs alone; drop --no-runs or "
            "--finite-strain");
    compare_with_finite_strains(options, options.elements);
}

}  // namespace

Command deviation_command() {
    return Declared<DeviationOptions>(
               Group::ask, "deviation",
               "How far the layer or the indenter's body of a case is from a "
               "half-space, or linear elasticity from finite strains",
               compare)
        .on_case()
        .jobs()
        .output("Folder (results/<case>_deviation, <case>_finite_strain or <case>_body_size)")
        .exports()
        .flag("--no-runs", &DeviationOptions::runs, "Exact theory alone: no friction, no rolling",
              false)
        .flag("--finite-strain", &DeviationOptions::finite_strain,
              "Linear elasticity against finite strains instead, by finite elements")
        .flag("--body", &DeviationOptions::body,
              "The indenter's body against a half-space instead, over its size, by sections")
        .number("--elements", &DeviationOptions::elements,
                "Elements in the contact radius, with --finite-strain (5)", 2, 20)
        .json()
        .quiet();
}

}  // namespace tricontact::app
