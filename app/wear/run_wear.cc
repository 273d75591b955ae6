#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/run_kinds.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/run/input_reading.h"
#include "contact/base/stopped.h"
#include "contact/models/model_kind.h"
#include "files/version.h"
#include "io/results/journal_file.h"
#include "io/results/output.h"
#include "io/results/progress.h"
#include "io/results/state_series.h"
#include "io/results/vtk_files.h"
#include "report/format.h"
#include "runs/point_key.h"
#include "wear/wear_report.h"

namespace tricontact::app {

namespace {

using wear::WearReport;
using wear::WearResult;

const std::string wear_again = std::string("tricontact run ") + resolved_case_name;
constexpr const char* time_in_cycles = "time_cycles";

io::OutputNames wear_outputs(const std::vector<std::string>& models) {
    io::OutputNames names{{resolved_case_name, "summary.json", "report.html"},
                          {io::paraview_macro_name}};
    for (const std::string& model : models)
        for (const char* name : {"/wear.csv", "/profiles.csv", "/wear.ex2"})
            names.results.push_back(model + name);
    return names;
}

/// Worn states in a journal beside the results, which a run that was killed goes on from.
class JournalledStates final : public wear::KeptStates {
  public:
    JournalledStates(const std::string& path, const std::string& key) : file_(path, key) {}
    std::vector<std::string> found() const override {
        std::vector<std::string> all;
        for (std::size_t k = 0; k < file_.size(); ++k) all.push_back(file_.read(k));
        return all;
    }
    void append(std::string_view bytes) override { file_.append(bytes); }
    void clear() override { file_.cut(0); }
    void finish() { file_.remove(); }

  private:
    io::JournalFile file_;
};

/// Shown states for ParaView; nothing of them is kept while the run goes on.
void write_states(const std::string& folder, const WearResult& result) {
    io::StateSeries series(folder, "wear", {files::version, wear_again}, time_in_cycles);
    const auto shown = wear::shown_states(result.history);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const auto& fields_of_state = result.shown[k];
        io::ExodusFields fields;
        fields.add_number(time_in_cycles, result.history.states[shown[k]].cycles);
        for (const auto& [name, field] : fields_of_state)
            fields.add_scalar(name, field, result.surface.size());
        series.add(result.history.states[shown[k]].cycles, io::mesh_of(result.surface), fields);
    }
    series.finish();
}

/// On cells twice as large, what they change in volume and depth. The run is none the worse for
/// what stops this.
void add_cells_error(const std::string& model, const Case& c, WearResult& result,
                     const RunCommandOptions& options) {
    options.say(fmt::format("{}: once more on coarser cells", model));
    result.why_no_cells = contact::why_it_stopped([&] {
        contact::CoarserModel coarser =
            options.makers->make_coarser(model, c, 2, options.threads, contact::silent);
        const auto history = wear::run_wear(c, *coarser.model);
        const wear::WornState& last = history.states.back();
        result.volume_of_cells = std::abs(last.volume - result.last().volume);
        result.depth_of_cells = std::abs(last.depth - result.last().depth);
        const auto limit_of = [](const wear::WornState& s) { return s.cycle.shakedown_limit; };
        if (std::isfinite(limit_of(last)) && std::isfinite(limit_of(result.last())))
            result.limits_of_cells = {std::abs(limit_of(history.states.front()) -
                                               limit_of(result.history.states.front())),
                                      std::abs(limit_of(last) - limit_of(result.last()))};
    });
}

WearResult wear_model(const std::string& model, const Case& c, const std::string& resolved,
                      const RunCommandOptions& options) {
    const std::string folder = options.output + '/' + model;
    io::make_output_folder(folder);
    const auto computed = options.makers->make(model, c, options.threads, options.sayer());
    JournalledStates kept(
        folder + '/' + io::journal_name,
        runs::program_identity() + '\n' + model + '\n' + resolved + '\n' + runs::file_digests(c));
    if (const std::size_t n = kept.found().size(); n > 0)
        options.say(fmt::format("{}: goes on from {} states of an earlier run", model, n));
    io::ProgressBar bar = options.progress_bar(model, "cycle");
    const int cycles = c.of<contact::Wear>().cycles;
    WearResult result =
        wear::told_result(c, *computed, {.kept = &kept, .show = [&](const wear::WornState& state) {
                                             bar.update(static_cast<int>(state.cycles), cycles);
                                         }});
    bar.finish("");
    if (options.studies && contact::model_kind(model).converges_in_order)
        add_cells_error(model, c, result, options);
    io::write_file(folder + "/wear.csv", wear::wear_csv(result.history));
    io::write_file(folder + "/profiles.csv", wear::profiles_csv(result));
    if (c.of<io::Output>().vtk != io::Output::Vtk::none) write_states(folder, result);
    kept.finish();
    return result;
}

std::string wear_summary(const WearReport& report, const std::string& resolved) {
    nlohmann::ordered_json json{{"version", report.version}, {"case", io::case_json(resolved)}};
    json.update(wear::wear_json(report));
    return json.dump(2) + '\n';
}

std::vector<std::pair<std::string, std::string>> files_of_wear(const Case& c) {
    std::vector<std::pair<std::string, std::string>> files{{"all numbers", "summary.json"}};
    for (const std::string& model : c.models) {
        const std::string name = report::display_name(model);
        files.emplace_back(name + ", over the cycles", model + "/wear.csv");
        files.emplace_back(name + ", profiles", model + "/profiles.csv");
        if (c.of<io::Output>().vtk != io::Output::Vtk::none)
            files.emplace_back(name + ", for ParaView", model + "/wear.ex2");
    }
    files.emplace_back("the case, resolved", resolved_case_name);
    return files;
}

void wear_models(const Case& c, const RunCommandOptions& options) {
    const std::string resolved = io::write_case(c);
    options.write(resolved_case_name, resolved);
    WearReport report{.c = c, .results = {}, .files = files_of_wear(c), .version = files::version};
    for (const std::string& model : c.models)
        report.results.push_back(wear_model(model, c, resolved, options));
    options.write("summary.json", wear_summary(report, resolved));
    options.write(io::paraview_macro_name, std::string(io::paraview_script));
    if (options.report) options.write_report(wear::wear_document(report), wear_again);
    options.answer(Answer([&] { return wear_summary(report, resolved); }, wear::wear_text(report))
                       .note(comparisons::left_out_lines(c, c.models)));
}

}  // namespace

void run_wear(const Case& c, RunCommandOptions options) {
    options.choose_folder();
    runs::require_models(c, options);
    for (const std::string& sentence : comparisons::input_sentences(c)) options.say(sentence);
    options.fill(wear_outputs(c.models), [&] { wear_models(c, options); });
    options.say(options.where());
}

}  // namespace tricontact::app
