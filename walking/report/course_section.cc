#include <algorithm>
#include <cmath>

#include "walking/report/walk_document.h"

namespace tricontact::walking {

namespace {

const std::string course_time_label = "time t [√(m/k_x)]";

/// Where the statistics begin; nothing if nothing follows.
void mark_transient(report::Figure& figure, const WalkResult& result) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
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
    const Machine& machine = report.walk_case.machine;
    const double sliding = sliding_force(machine);
    report::Curve mean{.name = "mean f_s"};
    for (const WalkWindow& window : report.walk.windows) {
        mean.add((window.begin + window.end) / 2,
                 window.sums.spring_force / static_cast<double>(window.sums.steps) / sliding);
    }
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
        for (report::Curve* curve : {&highest, &deepest})
            curve->x.push_back((window.begin + window.end) / 2);
        highest.y.push_back(window.sums.z_min / rest);
        deepest.y.push_back(window.sums.z_max / rest);
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
    for (std::size_t i = 1; i < returns.size(); ++i) {
        points.add(returns[i - 1].motion.z / rest, returns[i].motion.z / rest);
    }
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
