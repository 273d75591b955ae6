#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/base/special_values.h"
#include "report/format.h"
#include "statistics/regression.h"
#include "walking/report/walk_sweep_document.h"
#include "walking/study/walk_factorial.h"

namespace tricontact::walking {

namespace {

/// When runs reached their limit cycle, and how long the others were waited for.
struct Arrivals {
    std::vector<double> times;    ///< sorted
    std::vector<double> waiting;  ///< of runs that reached none
    std::size_t n() const { return times.size() + waiting.size(); }

    report::WithError share_by(double time) const {
        const auto arrived = std::upper_bound(times.begin(), times.end(), time) - times.begin();
        const double p = static_cast<double>(arrived) / static_cast<double>(n());
        return {p, statistics::normal_quantile(confidence) *
                       std::sqrt(p * (1 - p) / static_cast<double>(n()))};
    }
    /// Mean life of what ends at a constant rate, by maximum likelihood: all time waited over the
    /// number of ends.
    report::WithError mean_life() const {
        double sum = std::accumulate(times.begin(), times.end(), 0.);
        sum = std::accumulate(waiting.begin(), waiting.end(), sum);
        const auto n_ends = static_cast<double>(times.size());
        return {sum / n_ends,
                statistics::normal_quantile(confidence) * sum / n_ends / std::sqrt(n_ends)};
    }
};

Arrivals arrivals_of(const WalkSweep& sweep) {
    Arrivals arrivals;
    for (const WalkSweep::Point& point : sweep.points) {
        if (!point.outcome) continue;
        const WalkResult& result = point.outcome->result;
        if (result.regime == Regime::limit_cycle)
            arrivals.times.push_back(result.transient);
        else
            arrivals.waiting.push_back(result.transient + result.observed);
    }
    std::ranges::sort(arrivals.times);
    return arrivals;
}

report::DocumentTable arrival_table(const Arrivals& arrivals) {
    report::DocumentTable table{.id = "arrivals",
                                .title = "Runs on their limit cycle",
                                .note = "Errors: 95 %, of a share among so many runs.",
                                .columns = {{"by the time"}, {"runs"}, {"share [%]"}}};
    for (const double time : {500., 1000., 2000., 4000., 6000., 8000., 10000., 15000., 20000.}) {
        const report::WithError share = arrivals.share_by(time);
        std::vector<report::Cell>& row = table.rows.emplace_back();
        row.emplace_back(time);
        row.emplace_back(std::rint(share.value * static_cast<double>(arrivals.n())));
        row.emplace_back(report::WithError{100 * share.value, 100 * share.error});
    }
    return table;
}

report::Figure arrival_figure(const Arrivals& arrivals) {
    report::Figure figure{.id = "arrivals_over_time",
                          .title = "Runs on their limit cycle",
                          .caption =
                              "Share of the runs that have reached their limit cycle. Dashed: "
                              "chaos that ends at a constant rate, of the mean life found.",
                          .x = {"t"},
                          .y = {"share"}};
    report::Curve found{.name = "runs"}, decay{.name = "constant rate", .theory = true};
    const double life = arrivals.mean_life().value, end = arrivals.times.back();
    found.sample(0, end, 100, [&](double time) { return arrivals.share_by(time).value; });
    decay.sample(0, end, 100, [&](double time) { return 1 - std::exp(-time / life); });
    figure.curves = {found, decay};
    return figure;
}

/// Middle and half of what lies between the least and the largest of the limit cycles.
report::WithError span_of(const WalkSweep& sweep, double (*value)(const WalkOutcome& outcome)) {
    double least = contact::infinity, largest = -least;
    for (const WalkSweep::Point& point : sweep.points) {
        if (!point.outcome || point.outcome->result.regime != Regime::limit_cycle) continue;
        least = std::min(least, value(*point.outcome));
        largest = std::max(largest, value(*point.outcome));
    }
    return {(least + largest) / 2, (largest - least) / 2};
}

void add_arrivals(const WalkSweep& sweep, WalkSection& result) {
    const Arrivals arrivals = arrivals_of(sweep);
    if (arrivals.times.empty()) return;
    const auto period = span_of(sweep, [](const WalkOutcome& o) { return *o.result.period; });
    const auto friction = span_of(sweep, [](const WalkOutcome& o) { return o.result.mu_e; });
    const report::WithError life = arrivals.mean_life();
    result.verdicts.push_back(
        {.sentence = fmt::format(
             "{} of {} starts end on a limit cycle, all periods within {} ± {}, all μ_e within {} "
             "± {}. The mean life of the transient is {}.",
             arrivals.times.size(), arrivals.n(), report::significant(period.value, 6),
             report::significant(period.error, 2), report::significant(friction.value),
             report::significant(friction.error, 2), report::with_error(life.value, life.error))});
    result.section.figures.push_back(arrival_figure(arrivals));
    result.section.tables.push_back(arrival_table(arrivals));
}

void add_effects(const WalkSweep& sweep, WalkSection& result) {
    std::vector<std::size_t> axes(sweep.axes.size());
    std::iota(axes.begin(), axes.end(), 0);
    const std::vector<WalkGroup> runs = groups_over(sweep, axes);
    const auto factorial = factorial_of(sweep, runs, axes);
    if (!factorial) return;
    const ExclusionRule& all = exclusion_rules().back();
    const FactorialDesign kinetic =
        factorial->design(runs, all, [](const WalkOutcome& o) { return o.result.kinetic_energy; });
    double largest = 0;
    for (const MainEffect& effect : main_effects(kinetic)) {
        const auto [low, high] =
            std::ranges::minmax_element(effect.means, {}, &report::WithError::value);
        largest = std::max(largest, high->value / low->value - 1);
    }
    result.verdicts.push_back(
        {.sentence =
             fmt::format("The start changes the mean kinetic energy by at most {} (main effects).",
                         report::share(largest))});
    result.section.figures.push_back(main_effects_figure(
        "effects_on_kinetic_energy", "Kinetic energy at the end", "e_kin", kinetic));
    result.section.figures.push_back(main_effects_figure(
        "effects_on_initial_energy", "Mechanical energy at the start", "e_m(0)",
        factorial->design(runs, all, [](const WalkOutcome& o) { return o.initial_energy; })));
}

}  // namespace

std::optional<WalkSection> starts_section(const WalkSweep& sweep) {
    if (!machine_axes(sweep).empty() || sweep.axes.empty()) return {};
    WalkSection result{.section = {.id = "starts", .heading = "Starts"}};
    add_arrivals(sweep, result);
    add_effects(sweep, result);
    return result;
}

}  // namespace tricontact::walking
