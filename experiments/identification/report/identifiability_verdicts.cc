// Which parameters the observations do not determine, in sentences.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/identification/estimation/told_combination.h"
#include "experiments/identification/identification_report.h"
#include "experiments/identification/interface_parameters.h"
#include "experiments/identification/loop_values.h"

namespace tricontact::experiments {

namespace {

using report::Verdict;
using enum Verdict::Standing;

/// What would determine it.
std::string remedy_for(const FreeParameter& p) {
    if (p.key == "substrate.relaxation.times")
        return "Measure at more times around it, with smaller errors, or leave out its term of "
               "[substrate.relaxation].";
    if (p.key == "substrate.relaxation.relative_moduli")
        return "Measure at shorter times, with smaller errors, or leave out its term of "
               "[substrate.relaxation].";
    return "Measure over a wider range or with smaller errors, or leave " + p.key +
           " out of measurement.find.";
}

/// Of the term that a relaxation time belongs to: without it there is no such time.
bool may_have_no_term(const Identification& found, const FreeParameter& time) {
    if (time.key != "substrate.relaxation.times") return false;
    const auto k = found.find("substrate.relaxation.relative_moduli", time.index);
    return k && found.parameters[*k].likelihood.low <= found.free[*k].low;
}

std::optional<Verdict> not_identifiable(const IdentifiedModel& model, std::size_t k) {
    const FreeParameter& p = model.found.free[k];
    const auto [low, high] = model.found.parameters[k].likelihood;
    const bool is_logarithmic = p.scale == FreeParameter::Scale::logarithmic;
    const bool is_open_below = low <= p.low, is_open_above = high >= p.high;
    if (is_open_below && is_open_above)
        return Verdict{
            not_resolved,
            fmt::format("{}: {} is not identifiable: no value from {} to {} is "
                        "excluded{}. {}",
                        model.name, p.symbol, p.shown(p.low), p.shown(p.high),
                        may_have_no_term(model.found, p) ? ", for its term may be zero" : "",
                        remedy_for(p))};
    // Other scales end at values that a parameter may have.
    if (!is_logarithmic || !(is_open_below || is_open_above)) return {};
    return Verdict{not_resolved,
                   fmt::format("{}: {} is identifiable from one side only, {} {}. {}", model.name,
                               p.symbol, is_open_below ? "below" : "above",
                               p.shown(is_open_below ? high : low), remedy_for(p))};
}

/// Springs of any stiffness above a bound are as likely, up to what is rigid.
std::optional<Verdict> rigid_as_likely(const IdentifiedModel& model, std::size_t k,
                                       const char* rigid, const char* remedy) {
    const FreeParameter& p = model.found.free[k];
    const Interval interval = model.found.parameters[k].likelihood;
    if (std::isfinite(interval.high)) return {};
    return Verdict{
        not_resolved,
        fmt::format(
            "{}: {} is not identifiable: {} and {} are as likely. {}", model.name, p.symbol,
            interval.low <= p.low ? "all values" : "all values above " + p.shown(interval.low),
            rigid, remedy)};
}

constexpr const char* remedy_for_rig =
    "It is in series with the contact: measure at several loads and in gross slip, or state E.";
constexpr const char* remedy_for_interface =
    "Measure at smaller loads, where springs matter most, or with smaller errors.";

}  // namespace

std::vector<Verdict> identifiability_verdicts(const IdentifiedModel& model) {
    std::vector<Verdict> verdicts;
    std::vector<bool> is_named(model.found.free.size(), false);
    for (const ToldCombination& one : told_combinations(model.found)) {
        verdicts.push_back({not_resolved, model.name + ": " + sentence(one, model.found)});
        for (const std::size_t k : one.parameters) is_named[k] = true;
    }
    for (std::size_t k = 0; k < model.found.free.size(); ++k) {
        if (model.found.free[k].key == "friction.coefficient") {
            if (std::isinf(model.found.parameters[k].likelihood.high))
                verdicts.push_back(
                    {not_resolved, model.name +
                                       ": mu is not identifiable: all larger values are as likely. "
                                       "Measure at larger forces, closer to sliding."});
        } else if (model.found.free[k].key == rig_stiffness_key) {
            if (auto verdict = rigid_as_likely(model, k, "a rigid rig", remedy_for_rig))
                verdicts.push_back(std::move(*verdict));
        } else if (model.found.free[k].key == drift_key) {
            continue;  // loops' verdicts say what is known of it
        } else if (is_stiffness(model.found.free[k].key)) {
            if (auto verdict = rigid_as_likely(model, k, "a rigid interface", remedy_for_interface))
                verdicts.push_back(std::move(*verdict));
        } else if (!is_named[k]) {
            if (auto verdict = not_identifiable(model, k)) verdicts.push_back(std::move(*verdict));
        }
    }
    return verdicts;
}

}  // namespace tricontact::experiments
