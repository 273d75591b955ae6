#include "runs/case_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "comparisons/bodies/body_deviation.h"
#include "comparisons/half_space/layer_report.h"
#include "comparisons/quantities/left_out.h"
#include "comparisons/quantities/undefined.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/models/model_kind.h"
#include "io/case/case_reader.h"
#include "io/results/history_csv.h"
#include "io/results/journal.h"
#include "io/results/progress.h"
#include "report/gnuplot.h"
#include "runs/further_runs.h"
#include "runs/numerical_error.h"
#include "runs/point_key.h"
#include "runs/run_states.h"

namespace tricontact::runs {

void require_models(const Case& c, const RunOptions& options) {
    for (const std::string& name : c.models)
        if (options.makers && !options.makers->has(name))
            throw contact::InputError("models: this program was built without the model " + name +
                                      "; name others");
}

CaseRun run_models(const Case& c, const RunOptions& options, const Say& say,
                   const ModelRun& run_one) {
    require_models(c, options);
    CaseRun run{.c = c, .resolved = io::write_case(c), .histories = {}, .extras = {}};
    for (const std::string& name : c.models) {
        run.histories.push_back(run_one(name, options.studies ? &run.extras.study : nullptr));
        study_relaxation(c, run.histories.back(), options, say, run.extras.relaxation);
        study_small_strains(c, run.histories.back(), options, say, run.extras.small_strains);
    }
    run.extras.numerical = numerical_error(c, run.histories.back(), options, say);
    // Of both that tell what the indenter's body changes.
    if (const auto pair = comparisons::body_pair(c))
        for (const contact::History& history : run.histories)
            if (&history != &run.histories.back() &&
                (history.model == pair->body || history.model == pair->half_space))
                if (auto error = numerical_error(c, history, options, say))
                    run.extras.other_numerical.push_back(std::move(*error));
    return run;
}

std::string summary_of(const CaseRun& run) {
    using json = nlohmann::ordered_json;
    const Case& c = run.c;
    std::vector<comparisons::Results> summaries;
    for (const contact::History& history : run.histories)
        summaries.push_back(comparisons::results_beside(c, history, run.extras.study));
    const auto layer = comparisons::compare_with_layer(c, run.histories, run.extras.study);
    const auto bodies = comparisons::body_deviation(c, summaries, run.extras.study,
                                                    comparisons::errors_of(run.extras));
    json left_out = json::object();
    for (const contact::History& history : run.histories)
        if (const auto list = comparisons::left_out(c, history.model); !list.empty())
            left_out[history.model] = list;
    json undefined = json::object();
    for (const comparisons::Results& of_model : summaries)
        for (const auto& [quantity, why] : comparisons::why_undefined(c, of_model))
            undefined[of_model.model][quantity->key] = why;
    return comparisons::summary_json(
        files::version, io::case_json(run.resolved), summaries,
        {{"numerical_error",
          run.extras.numerical ? comparisons::numerical_error_json(*run.extras.numerical) : json()},
         {"left_out", left_out},
         {"undefined", undefined},
         {"layer", layer ? comparisons::layer_json(c, *layer) : json()},
         {"loading_variants", comparisons::loading_json(run.extras.study.variants)},
         {"relaxation",
          c.relaxation ? comparisons::relaxation_json(c, run.extras.relaxation) : json()},
         {"small_strains", comparisons::small_strains_json(run.extras.small_strains)},
         {"half_space_deviation", bodies ? comparisons::body_deviation_json(*bodies) : json()}});
}

namespace {

/// Of results that are there the user has to know this, also where it is quiet otherwise.
void warn(const CommandOptions& options, const std::string& line) {
    const std::string text = "warning: " + line;
    options.listener ? options.listener->say(text) : void(std::cerr << text << '\n');
}

}  // namespace

void write_run_report(const CaseRun& run, const CommandOptions& options) {
    report::Document document =
        comparisons::run_document(run.c, run.resolved, files::version, run.histories, run.extras);
    options.keep_report(document);
    if (options.papers.findings && !options.papers.findings->draws) return;
    std::vector<comparisons::ReportFile> files;
    try {
        files = comparisons::report_files(document);
    } catch (const report::GnuplotMissing&) {
        // The page draws its figures itself.
        document.plots.clear();
        options.write("report.html", report::document_html(document));
        warn(options, options.output +
                          "/plots is left out, since gnuplot is not there to draw it (install the "
                          "package gnuplot-nox); report.html has all figures");
        return;
    }
    io::make_output_folder(options.output + "/plots");
    for (const auto& file : files) options.write(file.name, file.content);
}

contact::History studied_history(const std::string& name, const Case& c, const RunOptions& options,
                                 const Say& say, const contact::Observer& observer,
                                 comparisons::LoadingStudy* study) {
    const auto model = options.makers->make(name, c, options.threads, say);
    contact::History history = contact::run(c, *model, observer);
    contact::require_sound(history.audit, name);
    if (study) study_loading(c, *model, history, say, *study);
    return history;
}

contact::History run_model(const std::string& name, const Case& c, const std::string& resolved,
                           const RunOptions& options, comparisons::LoadingStudy* study,
                           comparisons::ContactFilm* film) {
    const std::string folder = options.output + "/" + name;
    io::make_output_folder(folder);
    const Say say = options.sayer();
    auto made = options.makers->make(name, c, options.threads, say);
    io::JournalledModel* journal = nullptr;
    if (contact::model_kind(name).keeps_journal) {
        auto journalled = std::make_unique<io::JournalledModel>(
            std::move(made), folder + '/' + io::journal_name,
            program_identity() + '\n' + name + '\n' + resolved + file_digests(c), say);
        journal = journalled.get();
        made = std::move(journalled);
        if (journal->n_found() > 0)
            say(fmt::format("{}: {} steps of an earlier run are taken from {}/steps.journal", name,
                            journal->n_found(), folder));
    }
    contact::Model& model = *made;

    RunStates states(c, folder, say);
    io::ProgressBar bar = options.progress_bar(name);
    const contact::Observer observer = [&](const contact::StepRecord& record, contact::Model& state,
                                           const contact::Progress& progress) {
        bar.update(progress.step, progress.steps_at_most);
        const auto* section = states.add(record, state, progress);
        const auto surface = [&] { return states.surface() ? *states.surface() : state.surface(); };
        if (film) film->add(record, surface, progress);
        if (film && section) film->add_section(*section, progress.step);
    };
    contact::History history;
    try {
        history = contact::run(c, model, observer);
    } catch (const contact::NotConverged&) {
        states.finish();  // what did converge
        throw;
    }
    const auto* section = states.add_last(history.steps.back(), model);
    if (film && section) film->add_section(*section, static_cast<int>(history.steps.size()));
    history.subsurface = states.subsurface();
    history.audit = model.audit();
    contact::require_sound(history.audit, name);
    bar.finish(c.rolling ? contact::name_of(history.verdict.state) : "");

    io::write_file(folder + "/history.csv", io::history_csv(history));
    states.finish();
    if (study) study_loading(c, model, history, say, *study);
    if (journal) journal->finish();
    return history;
}

}  // namespace tricontact::runs
