#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/base/special_values.h"
#include "report/format.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_judge.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking {

namespace {

report::Figure motion_figure(const WalkReport& report) {
    const auto [x, z, phi, force] =
        motion_curves(report.walk_case.machine, last_swings(report.walk));
    return {.id = "motion",
            .title = "Motion",
            .caption =
                "Δx = (x - x_s)/(μ κ_4), height z over z_stat (downwards: negative is in the "
                "air), φ/(μ κ_3 κ_4) and spring force f_s over that of steady sliding. "
                "Wetter (2016), figures 4.5 and 4.6.",
            .x = {time_label},
            .y = {"dynamic quantities [-]"},
            .curves = {x, z, phi, force}};
}

/// Snapshots of the period that has the phases, from a little before its first one.
std::span<const Snapshot> period_of(const Walk& walk, const WalkPhases& phases) {
    const double begin = std::fmin(phases.sticking, phases.turning_point) - 0.1 * phases.period;
    const auto before = [](const Snapshot& snapshot, double time) {
        return snapshot.motion.time < time;
    };
    const auto first = std::lower_bound(walk.tail.begin(), walk.tail.end(), begin, before);
    return {first, std::lower_bound(first, walk.tail.end(), begin + phases.period, before)};
}

/// A point on the curve of z where a phase begins; none if it does not.
void mark(report::Figure& figure, const std::string& name, double time, double begin) {
    const report::Curve& z = figure.curves[1];
    const auto at = std::lower_bound(z.x.begin(), z.x.end(), time - begin - 1e-9);
    if (!std::isfinite(time) || at == z.x.end()) return;
    const double height = z.y[static_cast<std::size_t>(at - z.x.begin())];
    figure.curves.push_back(
        {.name = name, .x = {*at}, .y = {height}, .kind = report::Curve::Kind::points});
}

report::Figure period_figure(const WalkReport& report, const WalkPhases& phases) {
    const Machine& machine = report.walk_case.machine;
    const auto snapshots = period_of(report.walk, phases);
    const MotionCurves curves = motion_curves(machine, snapshots);
    const double load = machine.kappas.kappa5 * machine.kappas.kappa4;
    report::Figure figure{
        .id = "period",
        .title = "One period",
        .caption =
            "Way Δx = (x(t) - x(t_0))/(μ κ_4), z/z_stat, φ/(μ κ_3 κ_4), deflections of the "
            "spots n_i/(μ κ_4) and the phases of the motion: sticking spots going down (1), "
            "deepest and most energy stored (2), going up and forwards until the spots let "
            "go (3), in the air and fast forwards (4). Wetter (2016), figures 4.18 and 4.19.",
        .x = {time_label},
        .y = {"dynamic quantities [-]"}};
    const auto way = [&](const Snapshot& s) {
        return (s.motion.x - snapshots.front().motion.x) / load;
    };
    figure.curves = {over_time(snapshots, "Δx", way), curves.z, curves.phi};
    const std::size_t n_spots = spots_of(machine).size();
    for (std::size_t i = 0; i < n_spots && n_spots <= most_spots; ++i)
        figure.curves.push_back(
            over_time(snapshots, fmt::format("n_{}", i + 1),
                      [&](const Snapshot& s) { return s.motion.spots[i].normal / load; }));
    const double begin = snapshots.front().motion.time;
    mark(figure, "(1) sticking begins", phases.sticking, begin);
    mark(figure, "(2) turning point", phases.turning_point, begin);
    mark(figure, "(3) sticking ends", phases.release, begin);
    mark(figure, "(4) jump", phases.jump, begin);
    return figure;
}

report::Curve orbit(const Machine& machine, std::span<const Snapshot> snapshots,
                    const std::string& name, int colour) {
    report::Curve curve{.name = name, .x = motion_curves(machine, snapshots).displacement.y};
    curve.colour = colour;
    for (const Snapshot& snapshot : snapshots)
        curve.y.push_back(snapshot.motion.x_velocity / machine.kappas.kappa6);
    return curve;
}

report::Figure phase_plane(const WalkReport& report) {
    const Walk& walk = report.walk;
    const Machine& machine = report.walk_case.machine;
    report::Figure figure{.id = "phase_plane",
                          .title = "Phase plane",
                          .caption =
                              "Velocity of the body over that of the base, over its displacement "
                              "from the base. Wetter (2016), figure 4.17.",
                          .x = {"(x - x_s)/(μ κ_4) [-]"},
                          .y = {"x'/κ_6 [-]"}};
    if (!walk.start.empty()) {
        figure.caption += fmt::format(" The run begins below it, until t = {}.",
                                      report::significant(walk.start.back().motion.time, 3));
        figure.curves.push_back(orbit(machine, walk.start, "beginning", 4));
    }
    const bool cycle = walk.result.regime == Regime::limit_cycle;
    figure.curves.push_back(
        orbit(machine, last_swings(walk), cycle ? "limit cycle" : "end of the run", 0));
    return figure;
}

report::DocumentTable phase_table(const WalkPhases& phases) {
    const double begin = std::fmin(phases.sticking, phases.turning_point);
    const auto share = [&](double time) { return (time - begin) / phases.period; };
    return {.id = "phases",
            .title = "Phases of the period",
            .note =
                "Shares of the period from the first sticking on, to the interval between two "
                "recorded states.",
            .columns = {{"phase"}, {"begins at [period]", 3}},
            .rows = {{"(1) first spot sticks", share(phases.sticking)},
                     {"(2) deepest", share(phases.turning_point)},
                     {"(3) last spot lets go", share(phases.release)},
                     {"(4) jump: no spot touches", share(phases.jump)},
                     {"landing", share(phases.landing)}}};
}

const std::string course_time_label = "time t [√(m/k_x)]";

/// Where the statistics begin; nothing if nothing follows.
void mark_transient(report::Figure& figure, const WalkResult& result) {
    double low = contact::infinity, high = -low;
    for (const report::Curve& curve : figure.curves)
        for (const double value : curve.y) {
            low = std::fmin(low, value);
            high = std::fmax(high, value);
        }
    if (!(result.observed > 0 && low < high)) return;
    figure.curves.push_back({.name = "judged from",
                             .x = {result.transient, result.transient},
                             .y = {low, high},
                             .theory = true});
    figure.caption += result.transient_over ? " Dashed: end of the transient."
                                            : " Dashed: where the run is judged from, though its "
                                              "transient is not over.";
}

report::Figure force_figure(const WalkReport& report) {
    const double sliding = sliding_force(report.walk_case.machine);
    report::Curve mean{.name = "mean f_s"};
    for (const WalkWindow& window : report.walk.windows)
        mean.add((window.begin + window.end) / 2, mean_force(window) / sliding);
    report::Figure figure{
        .id = "force_means",
        .title = "Friction over the run",
        .caption =
            "Means of the spring force over windows of equal length, over that of "
            "steady sliding. They ripple where a window is no whole number of periods.",
        .x = {course_time_label},
        .y = {"mean force [-]"},
        .curves = {mean}};
    mark_transient(figure, report.walk.result);
    return figure;
}

report::Figure height_figure(const WalkReport& report) {
    const double rest = static_displacement(report.walk_case.machine);
    report::Curve highest{.name = "highest"}, deepest{.name = "deepest"};
    for (const WalkWindow& window : report.walk.windows) {
        const double middle = (window.begin + window.end) / 2;
        highest.add(middle, window.sums.z_min / rest);
        deepest.add(middle, window.sums.z_max / rest);
    }
    report::Figure figure{
        .id = "heights",
        .title = "Height over the run",
        .caption =
            "Extremes of z in each window over the static displacement, downwards; "
            "below 0 the body is in the air where it is not turned.",
        .x = {course_time_label},
        .y = {"z/z_stat [-]"},
        .curves = {highest, deepest}};
    mark_transient(figure, report.walk.result);
    return figure;
}

report::Figure return_map(const WalkReport& report) {
    constexpr std::size_t most = 1000;
    const double rest = static_displacement(report.walk_case.machine);
    const std::vector<SectionReturn>& all = report.walk.returns;
    const auto returns = std::span(all).last(std::min(all.size(), most));
    report::Curve points{.name = "return", .kind = report::Curve::Kind::points};
    for (std::size_t i = 1; i < returns.size(); ++i)
        points.add(returns[i - 1].motion.z / rest, returns[i].motion.z / rest);
    // Over all heights of the motion: the points of a limit cycle differ by less than can be seen.
    const std::vector<double> heights{report.walk.result.z_min_ratio,
                                      report.walk.result.z_max_ratio};
    report::Curve same{.name = "same again", .x = heights, .y = heights, .theory = true};
    return {.id = "returns",
            .title = "Return map",
            .caption =
                "Height at each return to the Poincaré section, where the body gets as fast "
                "as the spring's base, over that at the return before. A limit cycle is one "
                "point for each of its returns, chaos a cloud.",
            .x = {"z/z_stat at a return [-]"},
            .y = {"at the next one [-]"},
            .curves = {points, same}};
}

}  // namespace

report::DocumentSection motion_section(const WalkReport& report) {
    report::DocumentSection section{.id = "motion_section", .heading = "Motion"};
    section.figures.push_back(motion_figure(report));
    if (report.walk.phases) {
        section.figures.push_back(period_figure(report, *report.walk.phases));
        section.tables.push_back(phase_table(*report.walk.phases));
    }
    section.figures.push_back(phase_plane(report));
    return section;
}

report::DocumentSection course_section(const WalkReport& report) {
    report::DocumentSection section{.id = "course",
                                    .heading = "The whole run",
                                    .figures = {force_figure(report), height_figure(report)}};
    const Regime regime = report.walk.result.regime;
    if (regime == Regime::limit_cycle || regime == Regime::chaotic)
        section.figures.push_back(return_map(report));
    return section;
}

}  // namespace tricontact::walking
