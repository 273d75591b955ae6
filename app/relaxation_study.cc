#include "app/relaxation_study.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "comparisons/quantities/reference.h"
#include "comparisons/run/relaxation_report.h"
#include "contact/run.h"

namespace tricontact::app {

namespace {

using comparisons::RunValues;
using comparisons::SpeedLimit;
using comparisons::TwinComparison;
using contact::Case;

constexpr double no_load = 1e-9;  // of F_T over mu F_N: rounding

RunValues run_once(const Case& c, const std::string& model, int n_threads) {
    const auto silent = [](const std::string&) {};
    const auto made = make_model(model, c, n_threads, silent);
    return comparisons::run_values(contact::run(c, *made));
}

void run_twin(const Case& c, int n_threads, const Say& say, TwinComparison& comparison) {
    say(fmt::format("{}: once more on the relaxed, elastic substrate", comparison.model));
    try {
        comparison.elastic = run_once(comparisons::elastic_twin(c), comparison.model, n_threads);
    } catch (const std::runtime_error& error) {  // the run itself is none the worse for it
        comparison.why_none = error.what();
    }
    const std::string found = comparisons::twin_sentence(comparison);
    if (!found.empty()) say(found);
}

SpeedLimit speed_limit(const Case& c, const TwinComparison& known, int n_threads) {
    const auto error = [&](double speed) -> std::optional<double> {
        Case other = c;
        other.rolling->speed = speed;
        const auto found =
            comparisons::twin_error(*known.elastic, run_once(other, known.model, n_threads));
        return found ? std::optional(std::abs(*found)) : std::nullopt;
    };
    SpeedLimit limit = comparisons::find_speed_limit(*c.relaxation, known.drive->amplitude, error);
    limit.model = known.model;
    limit.of_increment = comparisons::judged_by_increment(*known.elastic);
    return limit;
}

}  // namespace

void study_relaxation(const Case& c, const contact::History& history, const RunOptions& options,
                      const Say& say, comparisons::RelaxationStudy& study) {
    if (!c.relaxation) return;
    TwinComparison comparison;
    comparison.model = history.model;
    comparison.drive = comparisons::drive_values(c, history.amplitude);
    comparison.relaxing = comparisons::run_values(history);
    if (!options.studies)
        comparison.why_none = "left out (--no-studies)";
    else if (std::abs(comparisons::tangential_ratio(history)) < no_load)
        comparison.why_none = "without F_T there is no shift to be compared";
    else if (history.model == "fem")
        comparison.why_none =
            "finite elements do not run again for it; name another model beside them";
    else
        run_twin(c, options.threads, say, comparison);
    study.twins.push_back(comparison);
    const bool comparable = comparison.drive && comparison.elastic &&
                            comparisons::twin_error(*comparison.elastic, comparison.relaxing);
    if (!comparable || study.limit) return;
    say(fmt::format("{}: looking for the drive speed from which on relaxation matters",
                    history.model));
    study.limit = speed_limit(c, comparison, options.threads);
}

}  // namespace tricontact::app
