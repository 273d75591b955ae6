#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "bem/model.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/quantities.h"
#include "comparisons/quantities/reference.h"
#include "comparisons/run/input_reading.h"
#include "comparisons/shakedown/limit_search.h"
#include "io/case/case_input.h"
#include "io/case/rolling_on.h"

namespace tricontact::app {

namespace {

using comparisons::LimitStudy;
using comparisons::LimitVariable;

struct LimitOptions : CommandOptions {
    std::string variable = "load";    ///< or "amplitude"
    std::optional<double> tolerance;  ///< of the bracket; empty: the models' own

    LimitVariable varied() const {
        return variable == "load" ? LimitVariable::load : LimitVariable::amplitude;
    }
};

void check(const LimitOptions& options, const Case& c) {
    io::refuse_rolling_on(c, options.file);
    if (c.prescribed_path)
        options.refuse(io::path_words(c) +
                       ": a limit of shakedown is that of rolling back and forth; give [load] and "
                       "[rolling] instead, or take tricontact run, which computes the path");
    if (!c.rolling)
        options.refuse(
            "there is no [rolling], and without it no limit of shakedown; add that section");
    if (!comparisons::constant_loads(c))
        options.refuse(
            "the loads oscillate, the limit is that under constant loads; leave out "
            "load.normal_amplitude_ratio and load.tangential_amplitude_ratio");
    if (options.varied() == LimitVariable::amplitude && c.load.is_by_limit())
        options.refuse(
            std::string(c.load.limit_key()) +
            " follows the amplitude: no amplitude is its limit; give load.tangential_ratio");
    const comparisons::Reference r = comparisons::reference(c);
    if (options.varied() == LimitVariable::amplitude && !(r.tangential_ratio > 0))
        options.refuse(
            "the tangential load is not positive: no amplitude ratchets; give "
            "load.tangential_ratio");
}

LimitStudy start_of(const LimitOptions& options, const Case& c) {
    const comparisons::Reference r = comparisons::reference(c);
    LimitStudy study;
    study.title = c.title;
    study.variable = options.varied();
    study.given = options.varied() == LimitVariable::load ? r.amplitude_ratio : r.tangential_ratio;
    study.angle = c.rolling->angle;
    study.round = contact::is_hertz_round(c);
    study.relaxing = c.relaxation.has_value();
    study.thesis = comparisons::thesis_limit(c, study.variable);
    return study;
}

/// What the limit's runs say of the border of a height map.
std::vector<comparisons::Results> borders_of(const LimitStudy& study) {
    std::vector<comparisons::Results> all;
    for (const auto& m : study.models) {
        if (!m.border_force_share) continue;
        comparisons::Results& one = all.emplace_back();
        one.model = m.model;
        one.set(comparisons::quantities::border_force_share, *m.border_force_share);
    }
    return all;
}

void find_limits(const Case& c, const LimitOptions& options) {
    const Say say = options.sayer();
    for (const std::string& sentence : comparisons::input_sentences(c)) say(sentence);
    LimitStudy study = start_of(options, c);
    for (const std::string& model : c.models)
        study.models.push_back(comparisons::search_limit(
            c, model,
            [&](const Case& at) { return options.makers->make(model, at, options.threads, say); },
            {options.varied(), options.tolerance}, say));
    std::string command = std::string("tricontact limit ") + resolved_case_name;
    if (options.varied() == LimitVariable::amplitude) command += " --vary amplitude";
    if (options.tolerance) command += fmt::format(" --tolerance {}", *options.tolerance);
    options.write(resolved_case_name, io::write_case(c));
    options.write("limit.json", comparisons::limit_json(files::version, study).dump(2) + "\n");
    options.write("limit.csv", comparisons::limit_csv(study));
    report::Document document = comparisons::limit_document(study);
    const std::vector<comparisons::Results> borders = borders_of(study);
    std::ranges::copy(comparisons::border_verdicts(c, borders),
                      std::back_inserter(document.verdicts));
    document.files = {{"all numbers", "limit.json"},
                      {"a row per model", "limit.csv"},
                      {"the case, resolved", resolved_case_name}};
    options.write_report(document, command);
    Answer answer([&] { return comparisons::limit_json(files::version, study).dump(2); },
                  comparisons::limit_text(study));
    answer.note(comparisons::left_out_lines(c, c.models));
    for (const auto& results : borders)
        if (const auto warning = comparisons::border_warning(results); !warning.empty())
            answer.note("warning: " + warning + '\n');
    options.answer(answer);
    options.say(options.where());
}

/// The limit of shakedown of each model: limit.json, limit.csv, the report, and a table on standard
/// output.
void limit_of_case(LimitOptions options) {
    const Case c = io::read_case(options.file, options.overrides, options.models);
    check(options, c);
    bem::check_influence_file(c);
    options.choose_folder("_limit");
    options.fill({{resolved_case_name, "limit.json", "limit.csv", "report.html"}},
                 [&] { find_limits(c, options); });
}

}  // namespace

Command limit_command() {
    return Declared<LimitOptions>(Group::ask, "limit",
                                  "Bisect the limit of shakedown of each model", limit_of_case)
        .on_case()
        .word("--vary", &LimitOptions::variable, "Limit in the load (f_T) or the amplitude (w)",
              {"load", "amplitude"})
        .number("--tolerance", &LimitOptions::tolerance,
                "Bracket width in f_T or w (default 1e-6 for mdr, 1e-3 otherwise)", 1e-9, 0.1)
        .models("These models instead of the case's")
        .output("Folder (results/<case>_limit)")
        .exports()
        .threads()
        .json()
        .quiet();
}

}  // namespace tricontact::app
