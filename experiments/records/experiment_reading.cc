#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/base/special_values.h"
#include "experiments/records/experiment_report.h"
#include "report/format.h"

namespace tricontact::experiments {

namespace {

using contact::State;
using report::Verdict;
using enum Verdict::Standing;

std::string runs(const ExperimentEvaluation& e) {
    return e.runs.size() == 1 ? "one run" : fmt::format("{} runs", e.runs.size());
}

// Runs of this verdict by the increment.
auto count(const ExperimentEvaluation& e, State state) {
    return std::ranges::count(
        e.runs, state, [](const RunEvaluation& run) { return run.stages.front().by_increment; });
}

std::string range_of_increment(double low, double high) {
    return fmt::format("between {} and {} µm", report::significant(um * low, 3),
                       report::significant(um * high, 3));
}

// Ratcheting: the mean of the runs by its scatter; what cannot be told: the range of all runs,
// whose verdicts differ; shakedown: the run with the largest upper end.
std::string increment_words(const ExperimentEvaluation& e) {
    const auto high = [](const RunEvaluation& r) { return r.stages[0].settling.increment.high; };
    const auto low = [](const RunEvaluation& r) { return r.stages[0].settling.increment.low; };
    const auto most = std::ranges::max_element(e.runs, {}, high);
    const bool repeats = e.runs.size() > 1;
    if (e.state == State::ratcheting)
        return fmt::format("the residual ratcheting beside the transient is {} per period ({}{})",
                           shift_text(increment_of_runs(e)), level(verdict_confidence),
                           repeats ? ", by the scatter of the runs" : "");
    if (e.state != State::shakedown)
        return fmt::format(
            "the residual ratcheting beside the transient is {} per period ({}{})",
            range_of_increment(low(*std::ranges::min_element(e.runs, {}, low)), high(*most)),
            level(verdict_confidence), repeats ? " of each run" : "");
    const StageEvaluation& stage = most->stages.front();
    const double added = std::max(0., stage.settling.increment.high * stage.periods());
    return fmt::format(
        "residual ratcheting contributes at most {:.2g} % of the shift in {} periods ({}{})",
        100 * added / std::abs(stage.shift.back()), stage.periods(), level(verdict_confidence),
        repeats ? ", the run that ratchets most" : "");
}

Verdict state_verdict(const ExperimentEvaluation& e) {
    const std::size_t n = e.runs.size();
    const bool expected = (e.kind == Experiment::Kind::shakedown) == (e.state == State::shakedown);
    if (e.state == State::undecided)
        return {not_resolved,
                fmt::format("Shakedown and ratcheting are not resolved after {} periods: "
                            "{}; of {}, {} settle and {} ratchet.",
                            e.periods, increment_words(e), runs(e), count(e, State::shakedown),
                            count(e, State::ratcheting))};
    const std::string state = e.state == State::shakedown ? "Shakedown" : "Ratcheting";
    const std::string where = n == 1 ? "" : fmt::format(" in {} of {} runs", count(e, e.state), n);
    return {expected ? pass : fail, state + where + ": " + increment_words(e) + "."};
}

Verdict curvature_verdict(const ExperimentEvaluation& e) {
    const Estimate& c = e.runs.front().stages.front().curvature;
    const State state = e.runs.front().stages.front().by_curvature;
    std::string sentence = fmt::format(
        "The thesis' criterion, the curvature of a parabola through U(t) (5.1.5-5.1.8), says "
        "\"{}\" in the first run: {} by the values of periods ({} of {} to {}).",
        word(state), report::significant(c.value, 3), level(verdict_confidence),
        report::significant(c.low, 3), report::significant(c.high, 3));
    if (e.state == State::ratcheting && state == State::shakedown)
        sentence += " It measures the bend of the transient; steady ratcheting is straight.";
    if (e.state == State::ratcheting && state == State::undecided)
        sentence += " A contact that ratchets steadily has no curvature.";
    return {finding, sentence};
}

Verdict values_verdict(const ExperimentEvaluation& e) {
    const std::string scatter =
        e.runs.size() > 1 ? "by the scatter of " + runs(e) : "of one run, by noise and drift";
    std::string sentence = fmt::format("U_stat = {}, ", shift_text(e.static_shift));
    if (e.kind == Experiment::Kind::ratcheting)
        sentence += fmt::format("ΔU = {} per period ({}, {}).", shift_text(e.increment),
                                level(e.confidence), scatter);
    else
        sentence += fmt::format(
            "U_sd = {} after {} periods ({}, {}){}.", shift_text(e.final_shift), e.periods,
            level(e.confidence), scatter,
            e.state == State::shakedown ? "; extrapolated " + shift_text(e.settled_shift) : "");
    return {finding, sentence};
}

Verdict limit_verdict(const ExperimentEvaluation& e) {
    if (!e.limit_amplitude)
        return {not_resolved,
                "No run has an amplitude that shakes down and a larger one that ratchets: the "
                "limit is not in the record."};
    const Estimate& w = e.limit_amplitude->at_confidence;
    const auto& first = **std::ranges::find_if(e.limits, [](const auto& l) { return bool(l); });
    const double ratio_limit = first.amplitude_low / w.value;
    return {finding,
            fmt::format("W_lim = {} mm ({} of {}, {}): between the last amplitude that shakes down "
                        "and the first that ratchets. Read as the last that shakes down it would "
                        "be {} mm, half a step lower: {} from the middle. U_lim = {} where the "
                        "straight lines through both intervals meet (5.1.9, 5.1.10).",
                        report::with_error(1e3 * w.value, 1e3 * w.half_width(), 4),
                        e.limit_amplitude->runs, runs(e), level(e.confidence),
                        report::significant(mm * e.last_shakedown->at_confidence.value, 4),
                        report::percent(ratio_limit), shift_text(*e.limit_shift))};
}

Verdict amplitude_verdict(const ExperimentEvaluation& e) {
    return {finding, fmt::format("The models roll as the drive did, by {}; the case states {}.",
                                 report::quantity(e.amplitude, "m", 3),
                                 report::quantity(*e.rolled_as.stated_amplitude, "m", 3))};
}

// Of a relaxing substrate.
Verdict rest_verdict(const ExperimentEvaluation& e) {
    const std::string rest = report::given_quantity(*e.rolled_as.hold, "s");
    if (!e.rolled_as.hold_is_known)
        return {not_resolved,
                fmt::format("The substrate relaxes, and the record does not say when F_T was "
                            "applied: the models rest under it for the {} that are recorded, the "
                            "rig rested longer. Give record.loading, or load.hold in the case.",
                            rest)};
    return {finding, fmt::format("The substrate relaxes: the models rest under F_T for {} before "
                                 "they roll, at {}, as {}.",
                                 rest, report::quantity(*e.rolled_as.speed, "m/s", 3),
                                 e.rest.is_whole ? "the record says" : "record and load.hold say")};
}

/// "F_N from 18.9 to 21.1 N, on average 20 N (the case states 21.1 N)".
std::string followed_force(const char* symbol, const RecordedPath::Range& range, double stated) {
    return fmt::format("{} from {} to {}, on average {} (the case states {})", symbol,
                       report::significant(range.low, 3), report::quantity(range.high, "N", 3),
                       report::quantity(range.mean, "N", 3), report::quantity(stated, "N", 3));
}

Verdict loads_verdict(const RecordedLoads& loads) {
    const RecordedPath& path = loads.as_recorded;
    std::vector<std::string> forces;
    if (path.normal_force.is_recorded)
        forces.push_back(followed_force("F_N", path.normal_force, loads.stated_normal));
    if (path.tangential_force.is_recorded)
        forces.push_back(followed_force("F_T", path.tangential_force, loads.stated_tangential));
    return {finding, fmt::format("The models get what was recorded: {}.", fmt::join(forces, "; "))};
}

// By the thesis' criterion, in the first run.
Verdict curvature_limit_verdict(const ExperimentEvaluation& e) {
    const auto& limit = e.limits_by_curvature.front();
    const auto& stages = e.runs.front().stages;
    const auto ratchets =
        std::ranges::count(stages, State::ratcheting, &StageEvaluation::by_curvature);
    const std::string found =
        limit ? fmt::format("puts the limit between {} mm and {} mm",
                            report::significant(mm * limit->amplitude_low, 4),
                            report::significant(mm * limit->amplitude_high, 4))
              : fmt::format("finds no limit: it finds ratcheting at {} of {} amplitudes", ratchets,
                            stages.size());
    return {finding, fmt::format("The thesis' criterion, the curvature of a parabola "
                                 "(5.1.5-5.1.8), {} in the first run, at {}.",
                                 found, level(verdict_confidence))};
}

Verdict model_limit_verdict(const ExperimentEvaluation& e, const PredictedLimit& limit) {
    const auto& stages = e.runs.front().stages;
    double low = 0, high = contact::infinity;
    for (std::size_t k = 0; k < stages.size() && !std::isfinite(high); ++k) {
        if (limit.states[k] == State::shakedown) low = stages[k].amplitude;
        if (limit.states[k] == State::ratcheting) high = stages[k].amplitude;
    }
    std::string range = fmt::format("between {} mm and {} mm", report::significant(mm * low, 4),
                                    report::significant(mm * high, 4));
    if (low == 0) range = fmt::format("below {} mm", report::significant(mm * high, 4));
    if (!std::isfinite(high)) range = fmt::format("above {} mm", report::significant(mm * low, 4));
    if (low == 0 && !std::isfinite(high)) range = "not resolved by these amplitudes";
    Verdict v{finding, fmt::format("{}: W_lim {}", report::display_name(limit.model), range)};
    if (e.limit_amplitude) {
        const Estimate& w = e.limit_amplitude->at_confidence;
        // Stages of runs agree to 1 %, so that neighbouring intervals only touch.
        const bool overlap = low < 0.99 * w.high && high > 1.01 * w.low;
        v.standing = overlap ? pass : fail;
        v.sentence += overlap ? ", as measured" : ", which the measurement excludes";
    }
    v.sentence += ".";
    return v;
}

Verdict drift_verdict(const ExperimentEvaluation& e) {
    const auto changes =
        std::ranges::count_if(e.runs, [](const RunEvaluation& run) { return run.drift_changes; });
    return {not_resolved,
            fmt::format("The drift changes in {} of {}, before or after the rolling, by more than "
                        "three standard errors: it is not linear, {}the substrate still creeps; "
                        "the errors are widened by the difference.",
                        changes, runs(e), e.rolled_as.loads ? "the forces change, or " : "or ")};
}

/// Where the pivot is over the contact, as far as that is more than its error.
std::string pivot_text(const Estimate& height) {
    const std::string size =
        report::with_error(1e6 * std::abs(height.value), 1e6 * height.standard_error, 3) + " µm";
    if (std::abs(height.value) <= height.standard_error)
        return "the pivot is level with the contact to " + size;
    return fmt::format("the pivot sits {} too {}", size, height.value > 0 ? "high" : "low");
}

Verdict wobble_verdict(const ExperimentEvaluation& e, const ModelPrediction& p) {
    const Estimate height = pivot_height(e, p.wobble);
    const Estimate& slope = e.wobble->at_confidence;
    return {finding, fmt::format("The shift follows the drive by {} µm/mm, of which {} has {} "
                                 "itself; by the rest {} (5.1.11, one standard error).",
                                 report::with_error(mm * slope.value, mm * slope.half_width(), 3),
                                 report::display_name(p.model),
                                 report::significant(mm * p.wobble, 3), pivot_text(height))};
}

}  // namespace

std::string level(double confidence) {
    return fmt::format("{:.4g} %", 100 * confidence);
}

std::string word(contact::State state) {
    return contact::name_of(state);
}

std::vector<Verdict> experiment_verdicts(const ExperimentEvaluation& e) {
    std::vector<Verdict> verdicts;
    if (e.kind == Experiment::Kind::limit) {
        verdicts = {limit_verdict(e), curvature_limit_verdict(e)};
        for (const PredictedLimit& limit : e.model_limits)
            verdicts.push_back(model_limit_verdict(e, limit));
        if (e.rolled_as.loads) verdicts.push_back(loads_verdict(*e.rolled_as.loads));
        if (e.rolled_as.hold) verdicts.push_back(rest_verdict(e));
    } else {
        verdicts = {state_verdict(e), values_verdict(e), curvature_verdict(e)};
        for (Verdict& verdict : limit_within_verdicts(e)) verdicts.push_back(std::move(verdict));
        for (Verdict& verdict : comparison_verdicts(e)) verdicts.push_back(std::move(verdict));
        if (e.rolled_as.stated_amplitude) verdicts.push_back(amplitude_verdict(e));
        if (e.rolled_as.loads) verdicts.push_back(loads_verdict(*e.rolled_as.loads));
        if (e.rolled_as.hold) verdicts.push_back(rest_verdict(e));
        for (const ModelPrediction& p : e.predictions)
            if (e.wobble && std::abs(p.wobble) > e.wobble->at_confidence.standard_error)
                verdicts.push_back(wobble_verdict(e, p));
    }
    for (Verdict& verdict : record_verdicts(e)) verdicts.push_back(std::move(verdict));
    if (std::ranges::any_of(e.runs, [](const RunEvaluation& run) { return run.drift_changes; }))
        verdicts.push_back(drift_verdict(e));
    return verdicts;
}

}  // namespace tricontact::experiments
