#include "app/case_run.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/loading_study.h"
#include "app/relaxation_study.h"
#include "comparisons/half_space/layer.h"
#include "comparisons/quantities/summary.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/error.h"
#include "files/version.h"
#include "io/case/case_writer.h"
#include "io/results/case_json.h"

namespace tricontact::app {

CaseRun run_models(const contact::Case& c, const RunOptions& options, const Say& say,
                   const ModelRun& run_one) {
    CaseRun run{.c = c, .resolved = io::write_case(c), .histories = {}, .extras = {}};
    for (const std::string& name : c.models) {
        run.histories.push_back(run_one(name, options.studies ? &run.extras.study : nullptr));
        study_relaxation(c, run.histories.back(), options, say, run.extras.relaxation);
    }
    return run;
}

std::string summary_of(const CaseRun& run) {
    using json = nlohmann::ordered_json;
    const contact::Case& c = run.c;
    std::vector<comparisons::Results> summaries;
    for (const contact::History& history : run.histories) summaries.emplace_back(c, history);
    const auto layer = comparisons::compare_with_layer(c, run.histories, run.extras.study);
    return comparisons::summary_json(
        files::version, io::case_json(run.resolved), summaries,
        {{"layer", layer ? comparisons::layer_json(c, *layer) : json()},
         {"loading_variants", comparisons::loading_json(run.extras.study.variants)},
         {"relaxation",
          c.relaxation ? comparisons::relaxation_json(c, run.extras.relaxation) : json()}});
}

contact::History history_of(const std::string& name, const contact::Case& c, int n_threads,
                            const Say& say, const contact::Observer& observer,
                            comparisons::LoadingStudy* study) {
    const auto model = make_model(name, c, n_threads, say);
    contact::History history = contact::run(c, *model, observer);
    require_sound(history.audit, name);
    if (study) study_loading(c, *model, history, say, *study);
    return history;
}

void require_sound(const contact::Audit& audit, const std::string& name) {
    for (const auto& check : audit.checks())
        if (!check.passed())
            throw contact::NotConverged(fmt::format("{}: {} is {:.2e}, allowed {:.1e}", name,
                                                    check.name, check.worst, check.allowed));
}

}  // namespace tricontact::app
