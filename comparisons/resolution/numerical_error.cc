#include "comparisons/resolution/numerical_error.h"

#include <algorithm>
#include <cmath>

#include "comparisons/resolution/refinement.h"

namespace tricontact::comparisons {

namespace {

using contact::State;
using json = nlohmann::ordered_json;

constexpr double factor_of_two_meshes = 3;  // Roache (1998), ch. 5
constexpr std::size_t most_band_points = 600;

/// `value`: of a run, empty if it has none.
template <class Value>
std::optional<double> half_width(const NumericalError& error, const Value& value) {
    if (!error.run || !error.coarser) return {};
    const std::optional<double> fine = value(*error.run), coarse = value(*error.coarser);
    if (!fine || !coarse) return {};
    const double change = std::abs(*fine - *coarse);
    double mesh = factor_of_two_meshes * change;
    if (error.coarsest) {
        const std::optional<double> coarsest = value(*error.coarsest);
        if (!coarsest) return {};
        mesh = safety_factor * std::max(change, std::abs(*coarse - *coarsest) / 2);
    }
    if (!error.long_steps) return mesh;
    const std::optional<double> long_steps = value(*error.long_steps);
    if (!long_steps) return {};
    return mesh + safety_factor * std::abs(*coarse - *long_steps);
}

/// What a case may ask first.
const std::vector<const Quantity*>& told_quantities() {
    using namespace quantities;
    static const std::vector<const Quantity*> list{
        &indentation,   &contact_radius,  &static_shift,        &final_shift,
        &settled_shift, &shift_increment, &settled_shift_ratio, &shift_increment_ratio};
    return list;
}

}  // namespace

ResolvedRun::ResolvedRun(const contact::Case& c, const contact::History& history)
    : results(c, history) {
    if (history.steps.empty()) return;
    // Loading comes at the first phase.
    const double first = history.steps.front().phase;
    phases.push_back(first);
    shifts.push_back(c.prescribed_path ? history.steps.front().shift[0] : history.static_shift);
    for (const contact::StepRecord& step : history.steps)
        if (step.phase > phases.back()) {
            phases.push_back(step.phase);
            shifts.push_back(step.shift[0]);
        }
}

double ResolvedRun::shift_at(double phase) const {
    const auto after = std::ranges::upper_bound(phases, phase);
    if (after == phases.begin()) return shifts.front();
    if (after == phases.end()) return shifts.back();
    const auto i = static_cast<std::size_t>(after - phases.begin());
    const double share = (phase - phases[i - 1]) / (phases[i] - phases[i - 1]);
    return std::lerp(shifts[i - 1], shifts[i], share);
}

std::optional<double> NumericalError::of(const Quantity& q) const {
    return half_width(*this, [&q](const ResolvedRun& r) { return r.results.number(q); });
}

report::Band NumericalError::shift_band(double unit) const {
    report::Band band;
    if (!run || !coarser) return band;
    for (const std::size_t k : report::thinned(run->phases.size(), most_band_points)) {
        const double phase = run->phases[k], shift = run->shifts[k];
        const double width = half_width(*this, [phase](const ResolvedRun& r) {
                                 return std::optional(r.shift_at(phase));
                             }).value_or(0);
        band.x.push_back(phase);
        band.low.push_back((shift - width) / unit);
        band.high.push_back((shift + width) / unit);
    }
    return band;
}

std::optional<State> NumericalError::other_state() const {
    if (!run) return {};
    const auto decided = [](std::optional<State> state) {
        return state && *state != State::undecided;
    };
    const std::optional<State> own = run->results.state();
    if (!decided(own)) return {};
    for (const auto* other : {&coarser, &coarsest, &long_steps})
        if (*other && decided((*other)->results.state()) && (*other)->results.state() != own)
            return (*other)->results.state();
    return {};
}

json numerical_error_json(const NumericalError& error) {
    if (error.model.empty()) return {};
    json widths = json::object();
    for (const Quantity* q : told_quantities())
        if (const auto width = error.of(*q)) widths[q->key] = *width;
    const auto other = error.other_state();
    return {{"model", error.model},
            {"half_widths", widths},
            {"other_state", other ? json(contact::name_of(*other)) : json()},
            {"why_none", error.why_none.empty() ? json() : json(error.why_none)}};
}

}  // namespace tricontact::comparisons
