#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/resolution/refined_values.h"
#include "comparisons/run/input_reading.h"
#include "contact/models/model_kind.h"
#include "files/digest.h"
#include "files/regular_file.h"
#include "io/keys/json_text.h"
#include "runs/case_run.h"
#include "runs/point_key.h"
#include "studies/refinement_levels.h"

namespace tricontact::app {

namespace {

using comparisons::Results;
using json = nlohmann::ordered_json;

const std::vector<std::string> level_results{resolved_case_name, "report.html", "refinement.csv",
                                             "refinement.json", "plots/"};

/// The numbers of a finished level.
struct Finished {
    Results values;
    double cpu_s = 0;
};

/// Empty if it cannot be read.
std::string read_text(const std::string& path) {
    constexpr std::uint64_t most_bytes = 100'000'000;
    try {
        return files::RegularFile(path).content(most_bytes);
    } catch (const files::Unreadable&) {
        return "";
    }
}

/// What a level.json holds: nothing of it is believed unless all of it is what belongs to its
/// numbers.
json document_of(const studies::Level& level, const Finished& done) {
    json document{
        {"version", files::version}, {"numerics", runs::numerics_digest()},
        {"case", level.resolved},    {"files", runs::file_digests(level.c)},
        {"cpu_s", done.cpu_s},       {"values", comparisons::stored_results(done.values)}};
    document["digest"] = files::digest_of(document.dump());
    return document;
}

/// Levels in the folders of a refinement. A level that is finished is not computed again as long as
/// program and case are the same, and its file is as it was written.
struct FinishedLevels {
    const studies::RefineOptions& options_;

    Finished finish(const studies::Level& level) const {
        if (const auto found = find(level)) return *found;
        return keep(level, run(level));
    }
    contact::History run(const studies::Level& level,
                         comparisons::LoadingStudy* study = nullptr) const {
        options_.say(fmt::format("{}: {}", level.name, level.what));
        io::make_output_folder(folder(level));
        // Those of an earlier call must not seem to be of this one while it is unfinished.
        io::remove_old_results(options_.output, level_results);
        io::remove_old_results(folder(level), {"level.json"});
        io::remove_old_results(folder(level) + '/' + options_.model, runs::model_results);
        runs::RunOptions options{options_};
        options.output = folder(level);
        return runs::run_model(options_.model, level.c, level.resolved, options, study);
    }
    Finished keep(const studies::Level& level, const contact::History& history) const {
        const Finished done{Results(level.c, history), history.cpu_s};
        io::write_file(file(level), document_of(level, done).dump(2) + "\n");
        return done;
    }
    std::optional<Finished> find(const studies::Level& level) const {
        const json found = io::parsed_json(read_text(file(level)));
        if (found.is_discarded() || !found.is_object()) return {};
        try {
            const Finished done{comparisons::read_stored_results(found.at("values")),
                                found.at("cpu_s").get<double>()};
            if (found != document_of(level, done)) return {};
            options_.say(fmt::format("{}: {}: taken from {}", level.name, level.what, file(level)));
            return done;
        } catch (const json::exception&) {  // not of our making
            return {};
        }
    }

    std::string folder(const studies::Level& level) const {
        return options_.output + "/" + level.name;
    }
    std::string file(const studies::Level& level) const { return folder(level) + "/level.json"; }
};

std::optional<comparisons::PressedValues> theory_of(const Case& c, bool layer) {
    if (!layer) {
        const bool exact = c.indenter.shape == Case::Shape::paraboloid ||
                           c.indenter.shape == Case::Shape::power_law;
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
    const Case& c = plan.levels.front().c;
    comparisons::RefinedLevels result;
    result.model = options.model;
    result.key = plan.key;
    result.wide_factor = plan.wide_factor;
    result.exact = theory_of(c, layer);
    result.exact_name = layer ? "exact layer" : contact::is_hertz_round(c) ? "Hertz" : "half-space";
    result.tolerance = kind.tolerance(c);
    result.infinite_pressure = contact::has_conical_tip(c);
    return result;
}

void add(const studies::Level& level, const Finished& done, comparisons::RefinedLevels& refined) {
    refined.sizes.push_back(level.size);
    refined.values.push_back(done.values);
    refined.cpu_s.push_back(done.cpu_s);
}

/// Adds the finest level, which comes last; it counts as finished when the report, which needs its
/// surfaces, is written.
comparisons::Refinement finish_last(const studies::Level& finest, const FinishedLevels& levels,
                                    comparisons::RefinedLevels& refined,
                                    const studies::RefineOptions& options) {
    const std::string& output = options.output;
    const std::string report = output + "/report.html", numbers = output + "/refinement.json";
    if (const auto found = levels.find(finest)) {
        comparisons::RefinedLevels all = refined;
        add(finest, *found, all);
        const comparisons::Refinement result = make_refinement(all);
        if (std::filesystem::exists(report) &&
            read_text(numbers) == refinement_json(files::version, result)) {
            refined = all;
            return result;
        }
        options.say(finest.name + ": once more, for the report");
    }
    comparisons::ReportExtras extras;
    const contact::History history = levels.run(finest, &extras.study);
    const Finished done{Results(finest.c, history), history.cpu_s};
    add(finest, done, refined);
    extras.refinement = make_refinement(refined);
    options.write(resolved_case_name, finest.resolved);
    runs::write_run_report({finest.c, finest.resolved, {history}, extras}, options);
    options.write("refinement.csv", refinement_csv(*extras.refinement));
    io::write_file(numbers, refinement_json(files::version, *extras.refinement));
    levels.keep(finest, history);
    return *extras.refinement;
}

// Results stay until a level has to be computed (Levels::run).
io::OutputNames names_of(const studies::RefinementPlan& plan) {
    io::OutputNames names{{}, level_results};
    for (const studies::Level& level : plan.levels) names.kept.push_back(level.name + '/');
    if (plan.wide) names.kept.push_back(plan.wide->name + '/');
    return names;
}

void refine_case(studies::RefineOptions options) {
    options.choose_folder("_refined");
    const FinishedLevels levels{options};
    const studies::RefinementPlan plan = studies::plan_refinement(options, options.sayer());
    for (const std::string& sentence : comparisons::input_sentences(plan.levels.front().c))
        options.say(sentence);
    comparisons::RefinedLevels refined = start_of(plan, options);
    comparisons::Refinement result;
    options.fill(names_of(plan), [&] {
        for (std::size_t k = 0; k + 1 < plan.levels.size(); ++k)
            add(plan.levels[k], levels.finish(plan.levels[k]), refined);
        if (plan.wide) refined.wide = levels.finish(*plan.wide).values;
        result = finish_last(plan.levels.back(), levels, refined, options);
    });

    options.out() << refinement_text(result);
    for (const std::string& sentence : refinement_sentences(result))
        options.out() << sentence << '\n';
    options.out() << comparisons::left_out_lines(plan.levels.back().c, {options.model});
    if (const auto warning = comparisons::border_warning(refined.values.back()); !warning.empty())
        options.out() << "warning: " << warning << '\n';
    options.say(options.where());
}

}  // namespace

Command refine_command() {
    return Declared<studies::RefineOptions>(Group::trust, "refine",
                                            "Run a case on finer and finer meshes: its errors",
                                            refine_case)
        .on_case()
        .number("--levels", &studies::RefineOptions::levels, "Number of levels (3)", 3, 8)
        .word("--model", &studies::RefineOptions::model, "Model to be refined (fem)",
              {contact::models::fem, contact::models::bem_layer, contact::models::bem})
        .output("Folder (results/<case>_refined)")
        .exports()
        .threads()
        .quiet("No progress");
}

}  // namespace tricontact::app
