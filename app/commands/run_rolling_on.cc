#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/commands/run_kinds.h"
#include "app/models/roll_models.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/resolution/fineness.h"
#include "comparisons/run/input_reading.h"
#include "contact/base/stopped.h"
#include "contact/models/model_kind.h"
#include "fem/settings.h"
#include "io/results/output.h"
#include "io/results/progress.h"
#include "io/results/state_series.h"
#include "io/results/vtk_files.h"
#include "report/format.h"
#include "rolling/rolling_document.h"
#include "runs/shown_states.h"

namespace tricontact::app {

namespace {

using rolling::RollingReport;

const std::string rolling_again = std::string("tricontact run ") + resolved_case_name;

io::OutputNames roll_outputs(const std::vector<std::string>& models) {
    io::OutputNames names{{resolved_case_name, "summary.json", "creep.csv", "report.html"},
                          {io::paraview_macro_name}};
    for (const std::string& model : models)
        for (const char* name : {"/history.csv", "/surface.ex2", "/indenter.ex2", "/steady.ex2"})
            names.results.push_back(model + name);
    return names;
}

/// States in each half length a of the way; of springs, which are many, the default.
double frames_of(const io::Output& output, const std::string& model) {
    if (output.vtk == io::Output::Vtk::all)
        return contact::model_kind(model).has_many_states ? io::Output{}.frames_per_period
                                                          : RollRuns::every_step;
    return output.vtk == io::Output::Vtk::frames ? output.frames_per_period : 0;
}

/// States from rest of so many `frames`, or of the report's lines; `spacing` [m] is a step.
double states_at_most(const Case& c, double frames, double spacing) {
    const double a = contact::half_space_scales(c).contact_radius;
    const double distance = c.tractive_rolling->distance;
    const auto n_lines =
        std::ranges::count_if(rolling::line_distances, [=](double way) { return way <= distance; });
    return std::max(static_cast<double>(n_lines),
                    1 + std::round(distance * std::min(frames, a / spacing)));
}

rolling::RollingRun roll_model(const std::string& model, const Case& c,
                               const RunCommandOptions& options) {
    const std::string folder = options.output + "/" + model;
    io::make_output_folder(folder);
    const io::Provenance provenance{files::version, rolling_again};
    const double speed = c.tractive_rolling->speed;
    const char* time = speed > 0 ? io::time_in_seconds : io::time_in_half_lengths;
    io::StateSeries surfaces(folder, "surface", provenance, time);
    io::StateSeries steady(folder, "steady", provenance, time);
    io::IndenterSeries indenters(folder, provenance, time);
    std::optional<io::IndenterShape> indenter;
    bool size_is_said = false;
    io::ProgressBar bar = options.progress_bar(model);
    RollRuns runs{.points = options.points,
                  .threads = options.threads,
                  .progress = [&](int step, int steps) { bar.update(step, steps); },
                  .show = {},
                  .frames = frames_of(c.of<io::Output>(), model),
                  .begin_again =
                      [&] {
                          surfaces.clear();
                          indenters.clear();
                          steady.clear();
                          indenter.reset();
                      },
                  .say = [&](const std::string& line) { options.say(line); }};
    if (c.of<io::Output>().vtk != io::Output::Vtk::none) {
        runs.show_steady = [&](const rolling::RollingHistory& history) {
            const contact::Surface& surface = history.surface;
            io::ExodusFields fields;
            io::begin_state(fields, {time, 0}, surface);
            if (const auto& found = history.temperatures) {
                fields.add_scalar("temperature_indenter_degC", found->indenter, surface.size());
                fields.add_scalar("temperature_substrate_degC", found->substrate, surface.size());
            }
            steady.add(0, io::mesh_of(surface), fields);
        };
        runs.show = [&](double way, const rolling::RollingState& state,
                        const contact::Surface& surface) {
            const double at = speed > 0 ? state.distance / speed : way;
            surfaces.add(at, surface);
            if (!indenter) indenter = runs::shown_indenter(c, surface);
            indenters.add(at, *indenter,
                          {.offset = surface.offset, .indentation = state.indentation});
            if (way > 0 && !std::exchange(size_is_said, true))
                options.say(runs::size_of_states(model,
                                                 states_at_most(c, runs.frames, surface.spacing[0]),
                                                 surfaces.last_size()));
        };
    }
    rolling::RollingRun run = roll(model, c, runs);
    bar.finish("");
    if (runs.show) steady.finish();
    io::write_file(folder + "/history.csv", rolling::history_csv(run));
    return run;
}

/// The steady state on cells, or springs, so many times as large; `size` [m] of elements.
rolling::RollingState coarser_steady(const std::string& model, const Case& c, double size,
                                     double factor, const RunCommandOptions& options) {
    Case coarser = c;
    const contact::ModelKind& kind = contact::model_kind(model);
    if (kind.is_meshed()) coarser.of<fem::Settings>().size = size;
    comparisons::change_resolution(coarser, kind, {.coarser = factor});
    return roll(model, coarser, {.points = 0, .both_ends = false, .threads = options.threads})
        .history.steady;
}

/// What cells leave in a model's steady state. The run is none the worse for what stops these.
rolling::SteadyError error_of(const std::string& model, const Case& c,
                              const rolling::RollingHistory& history,
                              const RunCommandOptions& options) {
    const double size = history.surface.spacing[0];
    options.say(fmt::format("{}: once more on coarser cells", model));
    rolling::RollingState coarser;
    const std::string why =
        contact::why_it_stopped([&] { coarser = coarser_steady(model, c, size, 2, options); });
    if (!why.empty()) return {.why_none = why};
    std::optional<rolling::RollingState> coarsest;
    contact::why_it_stopped([&] { coarsest = coarser_steady(model, c, size, 4, options); });
    const contact::ModelKind& kind = contact::model_kind(model);
    return rolling::steady_error(c, model, history.steady, coarser, coarsest,
                                 options.makers->solver_tolerance(model, c),
                                 kind.is_meshed() ? size : comparisons::cell_size(c, kind));
}

std::vector<std::pair<std::string, std::string>> files_of(const Case& c) {
    std::vector<std::pair<std::string, std::string>> files{{"all numbers", "summary.json"},
                                                           {"creep curves", "creep.csv"}};
    for (const std::string& model : c.models) {
        const std::string name = report::display_name(model);
        files.emplace_back(name + ", step by step", model + "/history.csv");
        if (c.of<io::Output>().vtk == io::Output::Vtk::none) continue;
        files.emplace_back(name + ", for ParaView", model + "/surface.ex2");
        files.emplace_back(name + " in steady rolling, for ParaView", model + "/steady.ex2");
    }
    files.emplace_back("the case, resolved", resolved_case_name);
    return files;
}

void write(const RollingReport& report, const std::string& resolved,
           const RunCommandOptions& options) {
    options.write("summary.json", roll_summary(report, resolved));
    options.write("creep.csv", rolling::creep_csv(report));
    options.write(io::paraview_macro_name, std::string(io::paraview_script));
    if (options.report) options.write_report(rolling::rolling_document(report), rolling_again);
}

void roll_models(const Case& c, const RunCommandOptions& options) {
    const std::string resolved = io::write_case(c);
    options.write(resolved_case_name, resolved);
    RollingReport report{.c = c, .runs = {}, .files = files_of(c), .version = files::version};
    for (const std::string& model : c.models) {
        rolling::RollingRun run = roll_model(model, c, options);
        if (options.studies) run.error = error_of(model, c, run.history, options);
        report.runs.push_back(std::move(run));
    }
    write(report, resolved, options);
    options.answer(
        Answer([&] { return roll_summary(report, resolved); }, rolling::steady_text(report))
            .note(comparisons::left_out_lines(c, c.models)));
}

}  // namespace

void run_rolling_on(const Case& c, RunCommandOptions options) {
    options.choose_folder();
    for (const std::string& sentence : comparisons::input_sentences(c)) options.say(sentence);
    options.fill(roll_outputs(c.models), [&] { roll_models(c, options); });
    options.say(options.where());
}

}  // namespace tricontact::app
