#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/records/experiment_report.h"
#include "report/format.h"

// What is wrong with the records, and where a case is too near to its limit for one statement.
namespace tricontact::experiments {

namespace {

using Standing = report::Verdict::Standing;

// Of all runs together there is a sentence on the drift.
bool is_told_here(const RecordFinding& finding) {
    return finding.kind != RecordFinding::Kind::drift;
}

report::Verdict record_verdict(const RunEvaluation& run) {
    std::vector<std::string> sentences;
    for (const RecordFinding& finding : run.findings)
        if (is_told_here(finding)) sentences.push_back(finding.sentence);
    const bool spoilt = !run.is_comparable();
    return {spoilt ? Standing::not_resolved : Standing::finding,
            fmt::format("{}: {}.{}", run.name, fmt::join(sentences, "; "),
                        spoilt ? " Its values are not compared with models." : "")};
}

/// "between 1.2 and 45.1 µm": of shifts at both ends and in the middle.
template <class Of>
std::string reach(const ModelPrediction& p, const Of& of) {
    std::vector<double> values{of(p.shift)};
    for (const std::vector<double>& end : p.ends) values.push_back(of(end));
    const auto [low, high] = std::ranges::minmax(values);
    return fmt::format("between {} and {} µm", report::significant(um * low, 3),
                       report::significant(um * high, 3));
}

report::Verdict limit_within_verdict(const ExperimentEvaluation& e, const ModelPrediction& p) {
    const bool ratchets = e.kind == Experiment::Kind::ratcheting;
    const std::string reached = ratchets
                                    ? reach(p, [](auto& u) { return late_increment(u, .95).value; })
                                    : reach(p, [](auto& u) { return u.back(); });
    return {Standing::not_resolved,
            fmt::format("{}: the limit lies within the uncertainty of the case. Shakedown and "
                        "ratcheting are both possible, ratcheting with a chance of some {:.0f} %; "
                        "{} is {} (95 %).",
                        report::display_name(p.model), 100 * *p.chance_of_ratcheting,
                        ratchets ? "ΔU" : "U_sd", reached)};
}

report::Verdict slides_verdict(const ModelPrediction& p) {
    return {Standing::not_resolved,
            fmt::format(
                "{}: within the uncertainty of the case F_T reaches what friction carries, and the "
                "contact slides: nothing bounds the shift.",
                report::display_name(p.model))};
}

}  // namespace

std::vector<report::Verdict> record_verdicts(const ExperimentEvaluation& e) {
    std::vector<report::Verdict> verdicts;
    for (const RunEvaluation& run : e.runs)
        if (std::ranges::any_of(run.findings, is_told_here))
            verdicts.push_back(record_verdict(run));
    return verdicts;
}

std::vector<report::Verdict> limit_within_verdicts(const ExperimentEvaluation& e) {
    std::vector<report::Verdict> verdicts;
    for (const ModelPrediction& p : e.predictions)
        if (p.slides_within)
            verdicts.push_back(slides_verdict(p));
        else if (p.chance_of_ratcheting)
            verdicts.push_back(limit_within_verdict(e, p));
    return verdicts;
}

Estimate increment_of_runs(const ExperimentEvaluation& e) {
    std::vector<Estimate> increments;
    double drift = 0;
    for (const RunEvaluation& run : e.runs) {
        const StageEvaluation& stage = run.stages.front();
        increments.push_back(stage.settling.increment);
        if (run.drift_changes)  // the same way in all runs
            drift = std::max(drift, run.drift.standard_error * stage.period);
    }
    if (increments.size() == 1) return increments.front();
    Estimate mean = repeated(increments, verdict_confidence).at_95;
    mean.widen(drift, statistics::normal_quantile(verdict_confidence) * drift);
    return mean;
}

}  // namespace tricontact::experiments
