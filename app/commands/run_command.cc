#include <cmath>
#include <iterator>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/run_kinds.h"
#include "atlas/run_section.h"
#include "bem/model.h"
#include "comparisons/differences/surface_difference.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/results.h"
#include "comparisons/run/input_reading.h"
#include "contact/verdict.h"
#include "contact/wearing_contact.h"
#include "io/results/output.h"
#include "io/results/vtk_files.h"
#include "report/format.h"
#include "walking/input/walk_reader.h"

namespace tricontact::app {

namespace {

io::OutputNames run_outputs(const std::vector<std::string>& models) {
    io::OutputNames names{{resolved_case_name, "summary.json", "report.html", "plots/"},
                          {io::paraview_macro_name}};
    for (const std::string& name : comparisons::difference_files(models))
        names.results.push_back(name);
    for (const std::string& model : models)
        for (const std::string& name : runs::model_results)
            names.results.push_back(model + '/' + name);
    return names;
}

std::vector<comparisons::Results> all_results(const runs::CaseRun& run) {
    std::vector<comparisons::Results> results;
    for (const contact::History& history : run.histories) results.emplace_back(run.c, history);
    return results;
}

runs::CaseRun compute(const Case& c, const runs::RunOptions& options) {
    runs::require_models(c, options);
    const std::string resolved = io::write_case(c);
    options.write(resolved_case_name, resolved);
    std::vector<report::Film> films;
    const auto run_one = [&](const std::string& name, comparisons::LoadingStudy* study) {
        comparisons::ContactFilm film(c);
        contact::History history =
            runs::run_model(name, c, resolved, options, study, options.report ? &film : nullptr);
        if (auto played = film.film(history)) films.push_back(std::move(*played));
        return history;
    };
    runs::CaseRun run = runs::run_models(c, options, options.sayer(), run_one);
    run.extras.films = std::move(films);
    options.write("summary.json", runs::summary_of(run));
    options.write(io::paraview_macro_name, std::string(io::paraview_script));
    const auto differences = comparisons::model_differences(run.histories);
    const io::Provenance provenance{files::version,
                                    std::string("tricontact run ") + resolved_case_name};
    if (c.of<io::Output>().vtk != io::Output::Vtk::none)
        for (const auto& one : differences)
            options.write(comparisons::difference_file(one.name_a, one.name_b),
                          comparisons::difference_vtk(one, provenance).bytes);
    if (!options.report) return run;
    if (auto section =
            comparisons::difference_section(differences, run.histories, run.extras.numerical))
        run.extras.sections.push_back(std::move(*section));
    if (auto section = atlas::place_in_maps(c, all_results(run)))
        run.extras.sections.push_back(std::move(*section));
    runs::write_run_report(run, options);
    return run;
}

/// "55.9 µm".
std::string metres(double value) {
    const report::Unit unit = report::fitting_unit(value, "m");
    return fmt::format("{:.3g} {}", value / unit.factor, unit.symbol);
}

const char* by_limit_words(contact::State state) {
    return state == contact::State::shakedown ? " (f_T is below the exact limit)"
                                              : " (f_T is above the exact limit)";
}

/// What a model came to, as a line for people: state, shift in micrometres or the like and in its
/// U_max, time. Without rolling and tangential force: the pressed contact.
std::string line_of(const comparisons::Results& r) {
    using namespace comparisons::quantities;
    std::string line = r.model + ": ";
    const auto length = [&r](const comparisons::Quantity& q) {
        return metres(r.number(q).value_or(0));
    };
    if (const auto state = r.state())
        fmt::format_to(std::back_inserter(line), "{}{}, ", contact::name_of(*state),
                       r.verdict.by_limit ? by_limit_words(*state) : "");
    if (const auto* regime = std::get_if<comparisons::SlipRegime>(&r[slip_regime]))
        line += fmt::format("{}, {} a cycle, F = {}, U = {} to either side",
                            comparisons::name_of(*regime),
                            report::quantity(r.number(dissipation).value_or(0), "J"),
                            report::quantity(r.number(loop_force).value_or(0), "N"),
                            report::quantity(r.number(loop_shift).value_or(0), "m"));
    else if (r.number(pull_off_force))
        line +=
            fmt::format("holds {} at most, a = {} then",
                        report::quantity(*r.number(pull_off_force), "N"), length(pull_off_radius));
    else if (!is_pressed_alone(r))
        fmt::format_to(std::back_inserter(line), "U = {} ({:.4g} U_max)", length(final_shift),
                       r.number(final_shift_ratio).value_or(0));
    else
        fmt::format_to(std::back_inserter(line), "d = {}, a = {}", length(end_indentation),
                       length(contact_radius));
    if (std::abs(r.verdict.remaining) > contact::known_shift &&
        std::isfinite(r.verdict.remaining_error))
        line += fmt::format(", {:.2g} +- {:.1g} U_max to come", r.verdict.remaining,
                            r.verdict.remaining_error);
    line += fmt::format("; {:.1f} s\n", r.number(wall_time).value_or(0));
    return r.verdict.missing.empty() ? line : line + "  undecided: " + r.verdict.missing + '\n';
}

void run_contact(const Case& c, RunCommandOptions options) {
    options.choose_folder();
    std::optional<runs::CaseRun> run;
    options.fill(run_outputs(c.models), [&] { run.emplace(compute(c, options)); });
    if (options.quiet && !options.json) return;
    Answer answer([&] { return runs::summary_of(*run); });
    for (const std::string& sentence : comparisons::input_sentences(c))
        answer.note(sentence + '\n');
    for (const contact::History& history : run->histories) {
        const comparisons::Results results(c, history);
        answer.add(line_of(results));
        for (const std::string& one : comparisons::left_out(c, history.model))
            answer.note("  leaves out " + one + '\n', history.model + ' ');
        if (const auto warning = comparisons::border_warning(results); !warning.empty())
            answer.note("warning: " + warning + '\n', history.model + ": ");
    }
    options.answer(answer.add(options.where() + '\n'));
}

/// Throws contact::InputError if the call has one of these options, which the kind of case that the
/// file shows itself to be does not have.
void refuse_options(const RunCommandOptions& options, const char* kind,
                    const std::vector<std::string>& others) {
    for (const std::string& name : others)
        if (std::ranges::find(options.given, name) != options.given.end())
            options.refuse(fmt::format("{} has no {}; leave it out", kind, name));
}

/// The file says of what kind it is.
void run_case(const RunCommandOptions& options) {
    if (walking::is_walk_case_file(options.file)) {
        refuse_options(options, "a case of the micro-walking machine",
                       {"--models", "--threads", "--points", "--no-studies"});
        return run_walking(options);
    }
    const Case c = io::read_case(options.file, options.overrides, options.models);
    bem::check_influence_file(c);  // before anything is written
    if (c.tractive_rolling) {
        refuse_options(options, "a case that rolls on", {"--no-studies"});
        return run_rolling_on(c, options);
    }
    refuse_options(options, "a case without [tractive_rolling]", {"--points"});
    if (c.kept.find<contact::Wear>()) return run_wear(c, options);
    run_contact(c, options);
}

}  // namespace

Command run_command() {
    return Declared<RunCommandOptions>(
               Group::compute, "run",
               "Run a case (contact, rolling on, walking machine): numbers, ParaView files, report",
               run_case)
        .on_case()
        .output("Folder for the results (results/<case>)")
        .models("Run these models instead of the case's")
        .exports()
        .threads()
        .quiet("No progress, no closing lines")
        .flag("--no-studies", &runs::RunOptions::studies, "Skip comparison runs", false)
        .number("--points", &RunCommandOptions::points,
                "Of a case that rolls on: points per creep curve (12; 0: none)", 0, 1000)
        .json("summary.json on standard output")
        .no_report("Skip report.html and the plots");
}

}  // namespace tricontact::app
