#include <fmt/format.h>

#include <iostream>

#include "app/commands/commands.h"
#include "app/models.h"
#include "app/run_model.h"
#include "bem/case_compliance.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/shakedown/limit_search.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/case/case_reader.h"
#include "io/case/case_writer.h"
#include "io/results/atomic_file.h"
#include "io/results/output_folder.h"

namespace tricontact::app {

namespace {

using comparisons::LimitStudy;
using comparisons::LimitVariable;
using contact::Case;

[[noreturn]] void refuse(const LimitOptions& options, const std::string& what,
                         const std::string& remedy) {
    throw contact::InputError(options.case_file + ": " + what + "; " + remedy);
}

void check(const LimitOptions& options, const Case& c) {
    refuse_rolling_on(c, options.case_file);
    if (!c.rolling)
        refuse(options, "there is no [rolling], and without it no limit of shakedown",
               "add that section");
    if (!comparisons::constant_loads(c))
        refuse(options, "the loads oscillate, the limit is that under constant loads",
               "leave out load.normal_amplitude_ratio and load.tangential_amplitude_ratio");
    const comparisons::Reference r = comparisons::reference(c);
    if (options.variable == LimitVariable::amplitude && !(r.tangential_ratio > 0))
        refuse(options, "the tangential load is not positive: no amplitude ratchets",
               "give load.tangential_ratio");
}

LimitStudy start_of(const LimitOptions& options, const Case& c) {
    const comparisons::Reference r = comparisons::reference(c);
    LimitStudy study;
    study.title = c.title;
    study.variable = options.variable;
    study.given = options.variable == LimitVariable::load ? r.amplitude_ratio : r.tangential_ratio;
    study.angle = c.rolling->angle;
    study.round = contact::is_hertz_round(c);
    study.relaxing = c.relaxation.has_value();
    study.thesis = comparisons::thesis_limit(c, options.variable);
    return study;
}

void write(const LimitStudy& study, const LimitOptions& options, const std::string& command) {
    const std::string& folder = options.output;
    io::write_file(folder + "/limit.json",
                   comparisons::limit_json(files::version, study).dump(2) + "\n");
    io::write_file(folder + "/limit.csv", comparisons::limit_csv(study));
    report::Document document = comparisons::limit_document(study);
    document.files = {{"all numbers", "limit.json"},
                      {"a row per model", "limit.csv"},
                      {"the case, resolved", resolved_case_name}};
    document.command = command;
    document.version = files::version;
    io::write_file(folder + "/report.html", report::document_html(document));
}

void find_limits(const Case& c, const LimitOptions& options) {
    const Say say = [&](const std::string& line) {
        if (!options.quiet) std::cerr << line << '\n';
    };
    LimitStudy study = start_of(options, c);
    for (const std::string& model : c.models)
        study.models.push_back(comparisons::search_limit(
            c, model, [&](const Case& at) { return make_model(model, at, options.threads, say); },
            {options.variable, options.tolerance}, say));
    std::string command = std::string("tricontact limit ") + resolved_case_name;
    if (options.variable == LimitVariable::amplitude) command += " --vary amplitude";
    if (options.tolerance) command += fmt::format(" --tolerance {}", *options.tolerance);
    io::write_file(options.output + "/" + resolved_case_name, io::write_case(c));
    write(study, options, command);
    std::cout << comparisons::limit_text(study);
    say("results in " + options.output + " (open report.html)");
}

}  // namespace

void limit_command(const LimitOptions& given) {
    LimitOptions options = given;
    const Case c = io::read_case(options.case_file, options.overrides, options.models);
    check(options, c);
    bem::check_influence_file(c);
    options.output = io::output_folder(options.output, options.case_file, "_limit");
    io::OutputFolder folder(options.output,
                            {{resolved_case_name, "limit.json", "limit.csv", "report.html"}});
    folder.fill([&] { find_limits(c, options); });
}

}  // namespace tricontact::app
