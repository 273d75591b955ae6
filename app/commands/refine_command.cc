#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/commands/command.h"
#include "app/models/make_model.h"
#include "comparisons/differences/field_changes.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/resolution/refined_values.h"
#include "comparisons/run/input_reading.h"
#include "contact/models/model_kind.h"
#include "files/regular_file.h"
#include "runs/case_run.h"
#include "runs/point_key.h"
#include "studies/level_outcome.h"
#include "studies/refinement_levels.h"

namespace tricontact::app {

namespace {

using comparisons::Results;

const std::vector<std::string> level_results{resolved_case_name, "report.html", "refinement.csv",
                                             "refinement.json", "plots/"};

/// Empty if it cannot be read.
std::string read_text(const std::string& path) {
    constexpr std::uint64_t most_bytes = 100'000'000;
    try {
        return files::RegularFile(path).content(most_bytes);
    } catch (const files::Unreadable&) {
        return "";
    }
}

/// Runs a level, with its history in a folder of its own, where a run that is killed goes on.
contact::History run_level(const studies::Level& level, const studies::RefineOptions& options,
                           comparisons::LoadingStudy* study = nullptr) {
    options.say(fmt::format("{}: {}", level.name, level.what));
    runs::RunOptions own{options};
    own.output = options.output + '/' + level.name;
    io::make_output_folder(own.output);
    io::remove_old_results(own.output + '/' + options.model, runs::model_results);
    return runs::run_model(options.model, level.c(), level.point.resolved, own, study);
}

std::optional<double> stiffness_of(const contact::History& history,
                                   const comparisons::LoadingStudy& study) {
    const auto found = study.normal_stiffness.find(history.model);
    return found == study.normal_stiffness.end() ? std::nullopt : std::optional(found->second);
}

/// Levels as points of a sweep.
class LevelKind : public studies::PointKind {
  public:
    LevelKind(const studies::RefineOptions& options, std::vector<studies::Level> levels)
        : options_(options), levels_(std::move(levels)) {}

    studies::StudyPoints points() const {
        studies::StudyPoints points;
        for (const studies::Level& level : levels_) points.push_back(level.point);
        return points;
    }
    std::string compute(const studies::StudyPoints&, const studies::Places& lot,
                        const studies::PointRuns&) const override {
        const studies::Level& level = levels_[lot.front()];
        studies::RefineOptions own = options_;
        // In a process of its own: no one there hears it, and several would speak at once.
        own.quiet = own.quiet || own.listener || own.jobs > 1;
        own.listener.reset();
        comparisons::LoadingStudy study{.with_variants = false};
        const contact::History history = run_level(level, own, &study);
        return studies::level_outcome_text(level.c(), history, stiffness_of(history, study));
    }
    void failed(const studies::StudyPoint& point, const std::string& why,
                bool refused) const override {
        const auto of_point = [&](const studies::Level& level) {
            return level.point.key == point.key;
        };
        const studies::Level& level = *std::ranges::find_if(levels_, of_point);
        const std::string text = fmt::format("{} ({}): {}", level.name, level.what, why);
        if (refused) throw contact::InputError(text);
        throw std::runtime_error(text);
    }

  private:
    const studies::RefineOptions& options_;
    std::vector<studies::Level> levels_;
};

/// Empty where no closed form has the contact, as on the springs of an elastic interface; those of
/// surfaces that attract each other are none of Hertz' kind.
std::optional<comparisons::PressedValues> theory_of(const Case& c, bool layer) {
    if (c.interface.is_elastic() || c.adhesion) return {};
    if (!layer) {
        const bool exact = c.indenter.shape == Case::Shape::paraboloid ||
                           c.indenter.shape == Case::Shape::power_law || c.is_line_contact();
        if (exact && contact::pressure_falls(c) && !contact::has_conical_tip(c))
            return comparisons::hertz_values(c);
        return {};
    }
    const auto comparison = comparisons::compare_with_layer(c, {});
    return comparison ? comparison->exact : std::nullopt;
}

comparisons::RefinedLevels start_of(const studies::RefinementPlan& plan,
                                    const studies::RefineOptions& options) {
    const contact::ModelKind& kind = contact::model_kind(options.model);
    const bool layer = kind.is_layer();
    const Case& c = plan.levels.front().c();
    comparisons::RefinedLevels result;
    result.model = options.model;
    result.key = plan.key;
    result.wide_factor = plan.wide_factor;
    result.exact = theory_of(c, layer);
    result.exact_name = layer ? "exact layer" : contact::is_hertz_round(c) ? "Hertz" : "half-space";
    result.tolerance = options.makers->solver_tolerance(options.model, c);
    result.infinite_pressure = contact::has_conical_tip(c);
    return result;
}

/// Levels with their last states.
struct LevelsWithStates : comparisons::RefinedLevels {
    std::vector<std::optional<contact::Snapshot>> last = {};
    std::optional<contact::Snapshot> wide_last = {};

    comparisons::Refinement refinement() const {
        comparisons::Refinement result = make_refinement(*this);
        result.fields = comparisons::refined_fields(sizes, last, wide_last);
        return result;
    }
};

void add(const studies::Level& level, const io::PointOutcome& outcome, LevelsWithStates& refined) {
    refined.sizes.push_back(level.size);
    const studies::LevelState state = studies::level_state_of(outcome);
    refined.values.push_back(*studies::results_of(outcome));
    if (state.normal_stiffness)
        refined.values.back().set(comparisons::quantities::normal_stiffness,
                                  *state.normal_stiffness);
    refined.last.push_back(state.last);
    refined.cpu_s.push_back(outcome.cpu_s);
}

void add_wide(const io::PointOutcome& outcome, LevelsWithStates& refined) {
    const studies::LevelState state = studies::level_state_of(outcome);
    refined.wide = studies::results_of(outcome);
    if (state.normal_stiffness)
        refined.wide->set(comparisons::quantities::normal_stiffness, *state.normal_stiffness);
    refined.wide_last = state.last;
}

/// What the store has of a level.
std::optional<io::PointOutcome> find(const studies::Level& level, const io::ResultStore& store,
                                     const studies::RefineOptions& options) {
    auto found = store.find(level.point.key);
    if (!found || !found->results) return {};
    options.say(fmt::format("{}: {}: taken from {}/{}", level.name, level.what, options.output,
                            io::result_store_name));
    return found;
}

/// Computes those of the levels that the store has not.
void compute(const std::vector<studies::Level>& levels, io::ResultStore& store,
             const studies::RefineOptions& options) {
    std::vector<studies::Level> open;
    for (const studies::Level& level : levels)
        if (!find(level, store, options)) open.push_back(level);
    if (open.empty()) return;
    // Those of an earlier call must not seem to be of this one while it is unfinished.
    io::remove_old_results(options.output, level_results);
    runs::CommandOptions processes = options;
    processes.threads = options.jobs;
    processes.quiet = options.quiet || (options.jobs == 1 && !options.listener);
    const LevelKind kind(options, std::move(open));
    studies::compute_missing(
        kind, kind.points(), store,
        {.name = "refine", .options = processes, .retry_failed = true, .noun = "level"});
}

/// Adds the finest level, which comes last; it counts as finished when the report, which needs its
/// surfaces, is written.
comparisons::Refinement finish_last(const studies::Level& finest, io::ResultStore& store,
                                    LevelsWithStates& refined,
                                    const studies::RefineOptions& options) {
    const std::string& output = options.output;
    const std::string report = output + "/report.html", numbers = output + "/refinement.json";
    const auto found = find(finest, store, options);
    if (found) {
        add(finest, *found, refined);
        comparisons::Refinement result = refined.refinement();
        if (std::filesystem::exists(report) &&
            read_text(numbers) == refinement_json(files::version, result))
            return result;
        options.say(finest.name + ": once more, for the report");
    }
    io::remove_old_results(output, level_results);
    comparisons::ReportExtras extras;
    const contact::History history = run_level(finest, options, &extras.study);
    io::PointOutcome outcome{finest.point.key, std::string(files::version), options.model,
                             finest.point.resolved};
    outcome.results =
        studies::level_results_text(finest.c(), history, stiffness_of(history, extras.study));
    outcome.cpu_s = history.cpu_s;
    outcome.wall_s = history.wall_s;
    if (!found) add(finest, outcome, refined);
    extras.refinement = refined.refinement();
    options.write(resolved_case_name, finest.point.resolved);
    runs::write_run_report({finest.c(), finest.point.resolved, {history}, extras}, options);
    options.write("refinement.csv", refinement_csv(*extras.refinement));
    io::write_file(numbers, refinement_json(files::version, *extras.refinement));
    store.add(outcome);
    return *extras.refinement;
}

// Results stay until a level has to be computed.
io::OutputNames names_of(const studies::RefinementPlan& plan) {
    io::OutputNames names{{}, level_results};
    for (const std::string& name : io::result_store_files()) names.kept.push_back(name);
    for (const studies::Level& level : plan.levels) names.kept.push_back(level.name + '/');
    if (plan.wide) names.kept.push_back(plan.wide->name + '/');
    return names;
}

void refine_case(studies::RefineOptions options) {
    options.choose_folder("_refined");
    const studies::RefinementPlan plan = studies::plan_refinement(options, options.sayer());
    for (const std::string& sentence : comparisons::input_sentences(plan.levels.front().c()))
        options.say(sentence);
    LevelsWithStates refined{start_of(plan, options)};
    comparisons::Refinement result;
    options.fill(names_of(plan), [&] {
        io::ResultStore store = studies::open_results(options.output);
        std::vector<studies::Level> coarser(plan.levels.begin(), plan.levels.end() - 1);
        if (plan.wide) coarser.push_back(*plan.wide);
        compute(coarser, store, options);
        for (const studies::Level& level : coarser) {
            const io::PointOutcome outcome = store.find(level.point.key).value();
            if (plan.wide && level.name == plan.wide->name)
                add_wide(outcome, refined);
            else
                add(level, outcome, refined);
        }
        result = finish_last(plan.levels.back(), store, refined, options);
    });

    std::string text = refinement_text(result);
    for (const std::string& sentence : refinement_sentences(result)) text += sentence + '\n';
    Answer answer([&] { return refinement_json(files::version, result); }, text);
    answer.note(comparisons::left_out_lines(plan.levels.back().c(), {options.model}));
    if (const auto warning = comparisons::border_warning(refined.values.back()); !warning.empty())
        answer.note("warning: " + warning + '\n');
    options.answer(answer);
    options.say(options.where());
}

}  // namespace

namespace {

/// The most complete first.
std::vector<std::string> refinable_models() {
    std::vector<std::string> models;
    for (const contact::ModelKind& kind : contact::model_kinds())
        if (*kind.resolution) models.insert(models.begin(), kind.name);
    return models;
}

}  // namespace

Command refine_command() {
    return Declared<studies::RefineOptions>(Group::trust, "refine",
                                            "Run a case on finer and finer meshes: its errors",
                                            refine_case)
        .on_case()
        .number("--levels", &studies::RefineOptions::levels, "Number of levels (3)", 3, 8)
        .word("-m,--models", &studies::RefineOptions::model, "Model to be refined, one (fem)",
              refinable_models())
        .output("Folder (results/<case>_refined)")
        .exports()
        .threads()
        .number("-j,--jobs", &studies::RefineOptions::jobs,
                "Levels side by side, but for the finest (1)", 1, 1024)
        .json()
        .quiet("No progress");
}

}  // namespace tricontact::app
