#include "experiments/identification/loop_findings.h"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/identification/identification_models.h"
#include "experiments/identification/law_parameters.h"
#include "experiments/identification/loop_regime.h"
#include "experiments/identification/loops/loop_stiffness.h"
#include "statistics/regression.h"

namespace tricontact::experiments {

namespace {

using Table = IdentificationInput::Table;

constexpr std::size_t most_blocks = 5;
constexpr std::size_t least_for_drift = 4;
// Of a parameter, over which what it does to a loop's friction is taken.
constexpr double largest_change = .05;

/// One table at work: rows with the errors of the fit.
struct TableErrors {
    const Table& table;
    std::vector<double> errors;  // [N], one per row
    double quantile = 0;         // of the intervals, in standard errors
    double widening = 1;         // of residuals with a pattern

    LoopRows rows(const MeasuredLoop& loop) const { return rows_of(table, loop, errors); }
};

/// The work around the measured rows and what the fitted loop has beyond the chords of its rows;
/// errors of the rows count by half the shift of their neighbours, those of shifts by the slope, as
/// residuals have them.
statistics::Estimate energy_of(const TableErrors& at, const LoopRows& rows, const FittedLoop& fit,
                               const LoopCurve& curve) {
    const double sum = work_around(rows.shifts, rows.forces);
    const double beyond = std::abs(curve.energy(fit.state.amplitude, fit.state.friction)) -
                          work_around(rows.shifts, fit.forces);
    double variance = 0;
    const std::size_t n = rows.shifts.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double way = (rows.shifts[(i + 1) % n] - rows.shifts[(i + n - 1) % n]) / 2;
        variance += way * way * rows.errors[i] * rows.errors[i];
    }
    return statistics::with_interval(sum + beyond, at.widening * std::sqrt(variance), at.quantile);
}

bool is_of_friction(const FreeParameter& p) {
    return is_of_law(p.key) || p.key == drift_key;
}

void find_friction(const IdentificationInput& input, const Identification& found,
                   const TableErrors& at, const MeasuredLoop& loop, LoopFinding& finding) {
    const LoopRows rows = at.rows(loop);
    const auto fitted = [&](const IdentifiedRig& rig) {
        const LoopCurve curve = loop_curve(rig, finding.normal_force);
        auto fit = fit_loop(rows, curve, finding.state.friction, true);
        return std::pair(
            fit.state.friction * curve.limit() / finding.normal_force,
            std::sqrt(fit.covariance[n_of_loop][n_of_loop]) * curve.limit() / finding.normal_force);
    };
    const auto [friction, error] = fitted(rig_with(input, found.free, found.best()));
    finding.shared_error = std::sqrt(shared_variance(
        input, found, [](const FreeParameter& p) { return !is_of_friction(p); },
        [&](const IdentifiedRig& rig) { return fitted(rig).first; }));
    // At a bound nothing of it is told.
    const double own = error > 0 ? at.widening * error : contact::infinity;
    finding.friction =
        statistics::with_interval(friction, std::hypot(own, finding.shared_error), at.quantile);
}

void find_stiffness(const TableErrors& at, const LoopRows& rows, LoopFinding& finding) {
    if (const auto weights = initial_stiffness(rows, finding.stiff_part()))
        finding.stiffness =
            statistics::with_interval(weighted(*weights, rows.forces),
                                      at.widening * weighted_error(*weights, rows), at.quantile);
}

/// The part of 4 F U of the contact that a cycle dissipates: by its rows, and by the fitted loop as
/// far as all loops tell it, each by its variance. Probability that it is below that of closed
/// loops.
double chance_of_closed(const IdentificationInput& input, const Identification& found,
                        const TableErrors& at, const MeasuredLoop& loop,
                        const LoopFinding& finding) {
    const LoopRows rows = at.rows(loop);
    const auto fitted = [&](const IdentifiedRig& rig) {
        const LoopCurve curve = loop_curve(rig, finding.normal_force);
        const auto state = fit_loop(rows, curve, friction_in(at.table, loop, rig)).state;
        const double force = curve.at(state.amplitude, state.friction).force;
        return curve.energy(state.amplitude, state.friction) /
               (4 * force * (state.amplitude - force * curve.rig_compliance()));
    };
    const double around = 4 * finding.force * finding.contact_shift;
    const double by_rows = std::pow(finding.energy.standard_error / around, -2);
    const double by_fit =
        1 /
        (std::pow(at.widening, 2) *
         std::max(1e-300, shared_variance(
                              input, found, [](const FreeParameter&) { return true; }, fitted)));
    const double ratio = (by_rows * finding.energy_ratio +
                          by_fit * fitted(rig_with(input, found.free, found.best()))) /
                         (by_rows + by_fit);
    return gsl_cdf_ugaussian_P((closed_loop_ratio - ratio) * std::sqrt(by_rows + by_fit));
}

std::optional<statistics::Estimate> drift_of(const std::vector<double>& cycles,
                                             const std::vector<double>& values, double confidence) {
    if (cycles.size() < least_for_drift) return {};
    const auto fit = statistics::fit_linear({std::vector<double>(cycles.size(), 1.), cycles},
                                            values, {.confidence = confidence});
    return fit.parameters[1];
}

statistics::Estimate mean_friction_of(std::span<const LoopFinding> loops, double quantile) {
    double weights = 0, sum = 0, shared = 0;
    for (const LoopFinding& loop : loops) {
        const double own = std::sqrt(std::max(
            1e-300, std::pow(loop.friction.standard_error, 2) - std::pow(loop.shared_error, 2)));
        const double weight = std::isfinite(own) ? 1 / (own * own) : 0;
        weights += weight;
        sum += weight * loop.friction.value;
        shared += weight * loop.shared_error;
    }
    if (!(weights > 0)) return loops.front().friction;
    return statistics::with_interval(
        sum / weights, std::hypot(1 / std::sqrt(weights), shared / weights), quantile);
}

LoopSeries series_of(std::span<const LoopFinding> loops, double confidence, double quantile) {
    LoopSeries series{.table = loops.front().table,
                      .n_loops = loops.size(),
                      .first_cycle = loops.front().cycle,
                      .last_cycle = loops.back().cycle};
    const auto n = static_cast<double>(loops.size());
    double variance = 0;
    std::vector<double> cycles, centres, offsets, stiff_cycles, stiffness;
    for (const LoopFinding& loop : loops) {
        series.normal_force += loop.normal_force / n;
        series.shift += loop.state.amplitude / n;
        series.energy.value += loop.energy.value / n;
        series.largest_ratio = std::max(series.largest_ratio, loop.energy_ratio);
        variance += std::pow(loop.energy.standard_error / n, 2);
        cycles.push_back(loop.cycle);
        centres.push_back(loop.state.centre);
        offsets.push_back(loop.state.force_offset);
        if (!loop.stiffness) continue;
        stiff_cycles.push_back(loop.cycle);
        stiffness.push_back(loop.stiffness->value);
    }
    series.energy = statistics::with_interval(series.energy.value, std::sqrt(variance), quantile);
    const std::size_t n_blocks = std::min(most_blocks, loops.size());
    for (std::size_t b = 0; b < n_blocks; ++b) {
        const std::size_t first = b * loops.size() / n_blocks,
                          end = (b + 1) * loops.size() / n_blocks;
        const auto part = loops.subspan(first, end - first);
        series.blocks.push_back(
            {part.front().cycle, part.back().cycle, part.size(), mean_friction_of(part, quantile)});
    }
    series.shift_drift = drift_of(cycles, centres, confidence);
    series.force_drift = drift_of(cycles, offsets, confidence);
    const double mean = std::accumulate(stiffness.begin(), stiffness.end(), 0.) /
                        static_cast<double>(stiffness.size());
    for (double& one : stiffness) one /= mean;
    series.stiffness_drift = drift_of(stiff_cycles, stiffness, confidence);
    std::tie(series.regime, series.confidence) = regime_of_series(loops);
    return series;
}

}  // namespace

double shared_variance(const IdentificationInput& input, const Identification& found,
                       const std::function<bool(const FreeParameter&)>& counts,
                       const std::function<double(const IdentifiedRig&)>& value) {
    const auto best = found.best();
    std::vector<double> slopes(found.free.size(), 0.);
    for (std::size_t k = 0; k < found.free.size(); ++k) {
        const FreeParameter& p = found.free[k];
        if (!counts(p)) continue;
        const double error = found.logarithmic.standard_errors[k];
        if (!std::isfinite(error) && is_of_law(p.key)) return contact::infinity;
        if (!std::isfinite(error) || !(error > 0)) continue;
        const double change = std::min(largest_change, error);
        auto above = best, below = best;
        above[k] = std::min(p.high, p.changed(best[k], change));
        below[k] = std::max(p.low, p.changed(best[k], -change));
        slopes[k] = (value(rig_with(input, found.free, above)) -
                     value(rig_with(input, found.free, below))) /
                    p.change(below[k], above[k]);
    }
    double variance = 0;
    const auto& c = found.logarithmic.adjusted;
    for (std::size_t k = 0; k < slopes.size(); ++k)
        for (std::size_t l = 0; l < slopes.size(); ++l) variance += slopes[k] * c[k][l] * slopes[l];
    return std::max(0., variance);
}

double LoopFinding::stiff_part() const {
    return experiments::stiff_part * std::min(1., sliding_shift / state.amplitude);
}

LoopFindings loop_findings(const IdentificationInput& input, const IdentificationTask& task,
                           const Identification& found) {
    LoopFindings findings;
    const IdentifiedRig rig = rig_with(input, found.free, found.best());
    SlidingChance chance(input, task, found);
    const double widening = found.widening.empty() ? 1 : std::ranges::max(found.widening);
    std::size_t n_series = 0;
    for (std::size_t t = 0; t < input.tables.size(); ++t) {
        const Table& table = input.tables[t];
        const TableErrors at{table, found.tables[t].standard_errors,
                             statistics::normal_quantile(found.confidence), widening};
        const auto curves = loop_curves(table, rig);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            const MeasuredLoop& loop = table.loops.loops[i];
            const LoopRows rows = at.rows(loop);
            const FittedLoop fit = fit_loop(rows, curves[i], friction_in(table, loop, rig));
            LoopFinding finding{.table = t,
                                .series = n_series + loop.series,
                                .cycle = loop.cycle,
                                .normal_force = load_of(loop, rig.as_case),
                                .state = fit.state};
            finding.force = curves[i].at(fit.state.amplitude, fit.state.friction).force;
            finding.contact_shift =
                fit.state.amplitude - finding.force * curves[i].rig_compliance();
            finding.sliding_shift = fit.state.friction * curves[i].sliding_shift();
            finding.energy = energy_of(at, rows, fit, curves[i]);
            const double around = 4 * finding.force * finding.contact_shift;
            finding.energy_ratio = finding.energy.value / around;
            finding.slides = chance.at(finding.state.amplitude / finding.sliding_shift);
            finding.sticks =
                (1 - finding.slides) * chance_of_closed(input, found, at, loop, finding);
            find_friction(input, found, at, loop, finding);
            find_stiffness(at, rows, finding);
            findings.loops.push_back(finding);
        }
        n_series += table.loops.n_series();
    }
    const double quantile = statistics::normal_quantile(found.confidence);
    for (std::size_t first = 0; first < findings.loops.size();) {
        std::size_t end = first;
        while (end < findings.loops.size() &&
               findings.loops[end].series == findings.loops[first].series)
            ++end;
        findings.series.push_back(series_of(std::span(findings.loops).subspan(first, end - first),
                                            found.confidence, quantile));
        first = end;
    }
    return findings;
}

}  // namespace tricontact::experiments
