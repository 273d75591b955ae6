#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/format.h"
#include "walking/machine/linear_stability.h"
#include "walking/report/walk_sweep_document.h"

namespace tricontact::walking {

namespace {

struct DrawnQuantity {
    const char *id, *title, *label, *caption;
    double (*value)(const WalkOutcome& outcome);
    std::vector<double> levels = {};
};

/// Of z_min/z_stat: beside the machines near tilting those that walk would all look alike.
constexpr double lowest_drawn = -30;

const std::vector<DrawnQuantity>& drawn_quantities() {
    static const std::vector<DrawnQuantity> all{
        {"friction",
         "Effective friction",
         "μ_e",
         "Mean spring force over friction under the weight; figures 4.9 and 4.24 of Wetter (2016).",
         [](const WalkOutcome& o) { return o.result.mu_e; },
         {0.2, 0.5, 0.95}},
        {"lowest_z",
         "Highest point of the body",
         "z_min/z_stat",
         "Below 0 the body leaves the ground; figure 4.10. What is below -30 is drawn as -30.",
         [](const WalkOutcome& o) { return std::max(o.result.z_min_ratio, lowest_drawn); },
         {-20, -10, -3, 0, 0.99}},
        {"stick_time_1", "Stick time of spot 1", "t_s1",
         "Share of time in which the rear spot sticks; figure 4.12.",
         [](const WalkOutcome& o) { return o.result.spots.front().stick_time; }},
        {"stick_time_2", "Stick time of spot 2", "t_s2",
         "Share of time in which the front spot sticks; figure 4.13.",
         [](const WalkOutcome& o) { return o.result.spots.back().stick_time; }},
        {"correlation_1", "Velocity and normal force of spot 1", "r_1",
         "Pearson's correlation: -1 moves only while unloaded; figure 4.14.",
         [](const WalkOutcome& o) { return o.result.spots.front().correlation; }},
        {"correlation_2", "Velocity and normal force of spot 2", "r_2", "The same; figure 4.15.",
         [](const WalkOutcome& o) { return o.result.spots.back().correlation; }},
        {"friction_error", "Error of the effective friction", "error of μ_e",
         "Half width of the 95 % interval of each run: wide where chaos has not ended.",
         [](const WalkOutcome& o) { return o.result.mu_e_error; }}};
    return all;
}

/// Least friction at which steady sliding flutters, over x; NaN: it does not below mu_c.
std::vector<double> flutter_over_x(const WalkGrid& grid) {
    std::vector<double> friction;
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
        const WalkGroup* cell = grid.cells[i];
        friction.push_back(
            cell ? flutter_friction(cell->points.front()->machine, grid.y.back()).value_or(NAN)
                 : NAN);
    }
    return friction;
}

bool is_nowhere(const std::vector<double>& friction) {
    return std::ranges::all_of(friction, [](double mu) { return std::isnan(mu); });
}

bool is_over_friction(const WalkSweep& sweep, const WalkGrid& grid) {
    return label_of(sweep, grid.y_axis) == "μ";
}

/// Where theory has sliding end, if friction is what y is.
std::vector<report::Curve> limit_curves(const WalkSweep& sweep, const WalkGrid& grid) {
    if (!is_over_friction(sweep, grid)) return {};
    report::Curve tilting{.name = "μ_c: tilts", .theory = true};
    for (std::size_t i = 0; i < grid.x.size(); ++i) {
        if (!grid.cells[i]) continue;
        const double friction = critical_friction(grid.cells[i]->machine());
        if (friction < grid.y.front() || friction > grid.y.back()) continue;
        tilting.add(grid.x[i], friction);
    }
    const std::vector<double> flutter = flutter_over_x(grid);
    if (is_nowhere(flutter)) return {tilting};
    return {tilting, {.name = "flutters", .x = grid.x, .y = flutter, .theory = true, .colour = 3}};
}

report::Figure map_figure(const WalkSweep& sweep, const WalkGrid& grid,
                          const DrawnQuantity& quantity) {
    return {.id = std::string("map_") + quantity.id,
            .title = quantity.title,
            .caption = std::string(quantity.caption) + " White: the machine tilts.",
            .x = {label_of(sweep, grid.x_axis)},
            .y = {label_of(sweep, grid.y_axis)},
            .curves = limit_curves(sweep, grid),
            .map = report::ContourMap{.label = quantity.label,
                                      .x = grid.x,
                                      .y = grid.y,
                                      .values = grid.values(quantity.value),
                                      .levels = quantity.levels}};
}

/// What most of a group's runs came to.
Regime regime_of(const WalkGroup& group) {
    int n[all_regimes.size()] = {};
    for (const auto* point : group.points)
        ++n[static_cast<std::size_t>(point->outcome->result.regime)];
    return static_cast<Regime>(std::max_element(std::begin(n), std::end(n)) - std::begin(n));
}

/// Cells are elements of the page.
constexpr std::size_t most_drawn_cells = 2500;

report::Figure regime_figure(const WalkSweep& sweep, const WalkGrid& grid) {
    report::Figure figure{
        .id = "map_regime",
        .title = "What becomes of each machine",
        .caption =
            "Steady sliding, a limit cycle, chaos that has not ended within the run, tilting, or "
            "sticking, where the run ends before the machine slides.",
        .x = {label_of(sweep, grid.x_axis)},
        .y = {label_of(sweep, grid.y_axis)}};
    for (const Regime regime : {Regime::steady, Regime::limit_cycle, Regime::chaotic,
                                Regime::tilting, Regime::sticking}) {
        report::Curve curve{.name = std::string(word_of(regime)),
                            .kind = report::Curve::Kind::points};
        for (std::size_t i = 0; i < grid.cells.size(); ++i) {
            if (!grid.cells[i] || regime_of(*grid.cells[i]) != regime) continue;
            curve.add(grid.x[i % grid.x.size()], grid.y[i / grid.x.size()]);
        }
        if (!curve.x.empty()) figure.curves.push_back(curve);
    }
    const auto limits = limit_curves(sweep, grid);
    figure.curves.insert(figure.curves.end(), limits.begin(), limits.end());
    return figure;
}

report::DocumentTable region_table(const WalkGrid& grid) {
    const std::vector<Region> judged = regions_of(grid, false), plain = regions_of(grid, true);
    report::DocumentTable table{
        .id = "regions",
        .title = "Shares of the map",
        .note =
            "Errors, 95 %: where in a cell a region ends, which a finer grid would resolve. Second "
            "half: plain means over it, the reading that gives the numbers of Wetter (2016); as "
            "judged: after the transient, whole periods of limit cycles.",
        .columns = {{"region"}, {"definition"}, {"as judged [%]"}, {"second half [%]"}}};
    for (std::size_t i = 0; i < judged.size(); ++i)
        table.rows.push_back({judged[i].name, judged[i].definition,
                              report::WithError{100 * judged[i].share, 100 * judged[i].grid_error},
                              report::WithError{100 * plain[i].share, 100 * plain[i].grid_error}});
    return table;
}

/// 99 %: cells that the boundary crosses cannot all agree.
constexpr double enough_agreement = 0.99;

/// An error of mu_e, 95 %, below which it counts as known.
constexpr double known_friction = 0.05;

report::Verdict agreement_verdict(const WalkGrid& grid) {
    const TiltingAgreement agreement = tilting_agreement(grid);
    const bool holds = agreement.share() >= enough_agreement;
    return {holds ? report::Verdict::Standing::pass : report::Verdict::Standing::finding,
            fmt::format("Machines tilt where μ > μ_c, so that they cannot slide steadily, and only "
                        "there, in {} of {} cells ({:.1f} %).{}",
                        agreement.n_agreeing, agreement.n_cells, 100 * agreement.share(),
                        holds ? "" : " What vibrates may stay upright above it or fall below.")};
}

/// Of the machines that do not tilt, how many slide steadily exactly where that is stable.
report::Verdict flutter_verdict(const WalkGrid& grid) {
    const std::vector<double> flutter = flutter_over_x(grid);
    int n = 0, n_agreeing = 0, n_steady_above = 0;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        const WalkGroup* cell = grid.cells[i];
        if (!cell || cell->tilts() || regime_of(*cell) == Regime::sticking) continue;
        const double limit = flutter[i % grid.x.size()];
        const bool stable = std::isnan(limit) || grid.y[i / grid.x.size()] < limit;
        const bool steady = regime_of(*cell) == Regime::steady;
        ++n;
        n_agreeing += stable == steady;
        n_steady_above += !stable && steady;
    }
    if (is_nowhere(flutter) && n_agreeing == n)
        return {.sentence = fmt::format("Steady sliding flutters nowhere below μ_c, and all {} "
                                        "machines that do not tilt slide steadily.",
                                        n)};
    if (is_nowhere(flutter))
        return {.sentence = fmt::format("Steady sliding flutters nowhere below μ_c, and yet {} of "
                                        "{} machines that do not tilt do not slide steadily: their "
                                        "vibration does not grow from small disturbances.",
                                        n - n_agreeing, n)};
    return {
        .sentence = fmt::format(
            "Linear stability predicts for {} of {} machines that do not tilt whether they slide "
            "steadily; {} slide though sliding flutters, {} do not though it is stable.",
            n_agreeing, n, n_steady_above, n - n_agreeing - n_steady_above)};
}

report::Verdict least_friction_verdict(const WalkSweep& sweep, const WalkGrid& grid) {
    const WalkGroup* least = nullptr;
    for (const WalkGroup* cell : grid.cells)
        if (cell && cell->mu_e().error < known_friction &&
            (!least || cell->mu_e().value < least->mu_e().value))
            least = cell;
    if (!least) return {.sentence = "No machine's friction is known."};
    const report::WithError friction = least->mu_e();
    return {.sentence = fmt::format(
                "The least friction, of those known to {}, is μ_e = {} at {} = {}, {} = {}.",
                known_friction, report::with_error(friction.value, friction.error),
                label_of(sweep, grid.x_axis),
                report::significant(shown_value(sweep, grid.x_axis, least->values[0])),
                label_of(sweep, grid.y_axis),
                report::significant(shown_value(sweep, grid.y_axis, least->values[1])))};
}

}  // namespace

WalkSection map_section(const WalkSweep& sweep, const WalkGrid& grid) {
    WalkSection result{.section = {.id = "map", .heading = "Map"}};
    if (std::ranges::any_of(grid.cells, [](const auto* cell) { return cell && cell->tilts(); }))
        result.verdicts.push_back(agreement_verdict(grid));
    if (is_over_friction(sweep, grid)) result.verdicts.push_back(flutter_verdict(grid));
    result.verdicts.push_back(least_friction_verdict(sweep, grid));
    for (const DrawnQuantity& quantity : drawn_quantities())
        result.section.figures.push_back(map_figure(sweep, grid, quantity));
    if (grid.cells.size() <= most_drawn_cells)
        result.section.figures.push_back(regime_figure(sweep, grid));
    result.section.tables.push_back(region_table(grid));
    return result;
}

}  // namespace tricontact::walking
