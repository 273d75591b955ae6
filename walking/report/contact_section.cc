#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "contact/special_values.h"
#include "walking/machine/motion.h"
#include "walking/report/walk_document.h"
#include "walking/report/walk_readings.h"

namespace tricontact::walking {

namespace {

/// The time a spot spends in a state as a strip between two heights.
report::Band strip(std::span<const Snapshot> snapshots, std::size_t spot, SpotState state,
                   const std::string& name, double low, double high, int colour) {
    report::Band band{.name = name, .colour = colour};
    const double begin = snapshots.front().motion.time;
    for (std::size_t i = 0; i < snapshots.size(); ++i) {
        const bool in = snapshots[i].spots[spot] == state;
        const bool ends =
            in && (i + 1 == snapshots.size() || snapshots[i + 1].spots[spot] != state);
        if (!in) continue;
        // Until the next state is seen: one that lasts for a single snapshot shows too.
        const std::size_t last = ends ? std::min(i + 1, snapshots.size() - 1) : i;
        for (const std::size_t at : {i, last}) {
            band.x.push_back(snapshots[at].motion.time - begin);
            band.low.push_back(low);
            band.high.push_back(high);
        }
        if (!ends) continue;
        band.x.push_back(band.x.back());
        band.low.push_back(contact::undefined);
        band.high.push_back(contact::undefined);
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
    report::Curve normal{.name = "normal force", .colour = 0};
    report::Curve friction{.name = "friction force", .colour = 1};
    report::Curve bound{.name = "its bounds", .theory = true};
    report::Curve below = bound;
    for (const Snapshot& snapshot : snapshots) {
        const SpotDeflection& deflection = snapshot.motion.spots[i];
        const auto force = spot_force(machine, spot, deflection);
        const double limit = friction_bound(machine, spot, deflection);
        const std::pair<report::Curve*, double> points[] = {{&normal, force.normal},
                                                            {&friction, force.tangential},
                                                            {&bound, limit},
                                                            {&below, -limit}};
        for (const auto& [curve, value] : points)
            curve->add(snapshot.motion.time - snapshots.front().motion.time,
                       value / machine.kappas.kappa4);
    }
    const double top = std::ranges::max(normal.y);
    return {.id = fmt::format("spot_{}", i + 1),
            .title = fmt::format("Forces of spot {}", i + 1),
            .caption =
                "In units of the weight; friction is positive against the motion. The "
                "strip tells when the spot sticks and when it slips; where it is "
                "interrupted, the spot is in the air.",
            .x = {time_label},
            .y = {"force [m g]"},
            .curves = {normal, friction, bound, below},
            .bands = {strip(snapshots, i, SpotState::stick, "sticks", 1.08 * top, 1.16 * top, 2),
                      strip(snapshots, i, SpotState::slip, "slips", 1.08 * top, 1.16 * top, 3)}};
}

/// Of many spots: shares of them in each state.
report::Figure share_figure(std::span<const Snapshot> snapshots) {
    report::Figure figure{.id = "spots",
                          .title = "What the spots do",
                          .caption = "Shares of all spots, or of all springs of their beds.",
                          .x = {time_label},
                          .y = {"share of spots [-]"}};
    for (const auto& [state, name] : {std::pair{SpotState::stick, "stick"},
                                      {SpotState::slip, "slip"},
                                      {SpotState::released, "in the air"}}) {
        report::Curve curve{.name = name};
        for (const Snapshot& snapshot : snapshots) {
            const auto n = std::count(snapshot.spots.begin(), snapshot.spots.end(), state);
            curve.add(snapshot.motion.time - snapshots.front().motion.time,
                      static_cast<double>(n) / static_cast<double>(snapshot.spots.size()));
        }
        figure.curves.push_back(curve);
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
    for (const SpotStatistics& spot : spots)
        table.rows.push_back(
            {static_cast<double>(spot.number), cell(spot.stick_time), cell(spot.correlation)});
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
