#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "contact/base/special_values.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_document.h"
#include "walking/run/walk_readings.h"

namespace tricontact::walking {

namespace {

/// The time a spot spends in a state as a strip between two heights.
report::Band strip(std::span<const Snapshot> snapshots, std::size_t spot, SpotState state,
                   const std::string& name, double low, double high, int colour) {
    report::Band band{.name = name, .colour = colour};
    const auto add = [&](const Snapshot& snapshot, double from, double to) {
        band.x.push_back(snapshot.motion.time - snapshots.front().motion.time);
        band.low.push_back(from);
        band.high.push_back(to);
    };
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        if (snapshots[i].spots[spot] != state) continue;
        const Snapshot& next = snapshots[std::min(i + 1, snapshots.size() - 1)];
        const bool ends = i + 1 == snapshots.size() || next.spots[spot] != state;
        add(snapshots[i], low, high);
        // Until the next state is seen: one that lasts for a single snapshot shows too.
        add(ends ? next : snapshots[i], low, high);
        if (ends) add(next, contact::undefined, contact::undefined);
    }
    return band;
}

/// Greatest friction force of the spot, in units of k_x b; without coupling a constant of its own.
double friction_bound(const Machine& machine, const Spot& spot, const SpotDeflection& deflection) {
    if (!machine.mechanisms.coupling) return contact::undefined;
    const double contacts = machine.model == Machine::Model::prism ? 2 : spot.stiffness;
    return contacts * machine.kappas.kappa5 * machine.kappas.kappa2 * deflection.normal;
}

report::Figure spot_figure(const Machine& machine, std::span<const Snapshot> snapshots,
                           std::size_t i) {
    const Spot spot = spots_of(machine)[i];
    const auto curve = [&](const char* name, auto value) {
        return over_time(snapshots, name, [&](const Snapshot& s) {
            return value(s.motion.spots[i]) / machine.kappas.kappa4;
        });
    };
    using Deflection = const SpotDeflection&;
    report::Curve normal =
        curve("normal force", [&](Deflection d) { return spot_force(machine, spot, d).normal; });
    report::Curve friction = curve(
        "friction force", [&](Deflection d) { return spot_force(machine, spot, d).tangential; });
    report::Curve bound =
        curve("its bounds", [&](Deflection d) { return friction_bound(machine, spot, d); });
    report::Curve below = bound;
    for (double& value : below.y) value = -value;
    normal.colour = 0, friction.colour = 1, bound.theory = below.theory = true;
    const double top = std::ranges::max(normal.y);
    return {.id = fmt::format("spot_{}", i + 1),
            .title = fmt::format("Forces of spot {}", i + 1),
            .caption =
                "In units of the weight; friction is positive against the motion. The "
                "strip shows when the spot sticks and when it slips; where it is "
                "interrupted, the spot is in the air.",
            .x = {time_label},
            .y = {"force [m g]"},
            .curves = {normal, friction, bound, below},
            .bands = {strip(snapshots, i, SpotState::stick, "sticks", 1.08 * top, 1.16 * top,
                            report::stick_style),
                      strip(snapshots, i, SpotState::slip, "slips", 1.08 * top, 1.16 * top,
                            report::slip_style)}};
}

/// Of many spots: shares of them in each state.
report::Figure share_figure(std::span<const Snapshot> snapshots) {
    report::Figure figure{.id = "spots",
                          .title = "What the spots do",
                          .caption = "Shares of all spots, or of all springs of their beds.",
                          .x = {time_label},
                          .y = {"share of spots [-]"}};
    for (const auto& [state, name, style] :
         {std::tuple{SpotState::stick, "stick", report::stick_style},
          {SpotState::slip, "slip", report::slip_style},
          {SpotState::released, "in the air", 2}}) {
        const auto share = [state = state](const Snapshot& s) {
            return static_cast<double>(std::ranges::count(s.spots, state)) /
                   static_cast<double>(s.spots.size());
        };
        figure.curves.push_back(over_time(snapshots, name, share));
        figure.curves.back().colour = style;
    }
    return figure;
}

report::DocumentTable spot_table(const std::vector<SpotStatistics>& spots) {
    report::DocumentTable table{
        .id = "spot_statistics",
        .title = "Spots",
        .note =
            "r: correlation of a spot's velocity and normal deflection; negative "
            "where it moves while it presses little. Wetter (2016), eqs. 4.2.14 "
            "to 4.2.16 and A.1.4. Errors: 95 % intervals, none on a limit cycle.",
        .columns = {{"spot"}, {"stick time [T]", 4}, {"r [-]", 3}}};
    const auto cell = [](const report::WithError& r) {
        return std::isnan(r.error) ? report::Cell(r.value) : report::Cell(r);
    };
    for (const auto& [stick_time, correlation] : spots)
        table.rows.push_back(
            {static_cast<double>(table.rows.size() + 1), cell(stick_time), cell(correlation)});
    return table;
}

}  // namespace

report::DocumentSection contact_section(const WalkReport& report) {
    report::DocumentSection section{.id = "contacts", .heading = "Contact spots"};
    const auto snapshots = last_swings(report.walk);
    const std::size_t n_spots = spots_of(report.walk_case.machine).size();
    if (!snapshots.empty() && n_spots > most_spots)
        section.figures.push_back(share_figure(snapshots));
    for (std::size_t i = 0; !snapshots.empty() && i < n_spots && n_spots <= most_spots; ++i)
        section.figures.push_back(spot_figure(report.walk_case.machine, snapshots, i));
    const std::vector<SpotStatistics> spots = spot_statistics(report.walk);
    if (!spots.empty() && n_spots <= most_spots) section.tables.push_back(spot_table(spots));
    return section;
}

}  // namespace tricontact::walking
