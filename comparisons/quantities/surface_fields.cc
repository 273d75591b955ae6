#include "comparisons/quantities/surface_fields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace tricontact::comparisons {

namespace {

using contact::ContactState;
using contact::History;
using contact::Snapshot;
using contact::Surface;

constexpr double phase_tolerance = 1e-6;  // phases are sums of fractions of a period

/// Normal load, tangential load and friction bound of one point: tractions, or the springs' line
/// loads.
struct PointLoad {
    double normal, tangential, bound;
};

PointLoad point_load(const Surface& s, const contact::FrictionLaw& friction, std::size_t i) {
    if (s.layout == Surface::Layout::line)
        return {s.normal_line_load[i], std::abs(s.tangential_line_load[i]),
                friction.coulomb().value_or(0) * s.normal_line_load[i]};
    return {s.normal_traction[i],
            std::hypot(s.tangential_traction_x[i], s.tangential_traction_y[i]),
            s.friction_bound[i]};
}

/// One instant: at the bound means within a percent of it, because points approach shakedown from
/// below and a grid never hits the border of the stick zone, where tau/(mu p) -> 1 steeply.
Zone zone_at(const Surface& s, const contact::FrictionLaw& friction, std::size_t i) {
    const PointLoad load = point_load(s, friction, i);
    // Between resampled nodes a trace of pressure remains beside the contact.
    if (load.normal <= 0 || s.contact_state[i] == ContactState::open) return Zone::open;
    const bool at_bound = load.tangential >= 0.99 * load.bound && load.bound > 0;
    return at_bound || s.contact_state[i] == ContactState::slip ? Zone::slip : Zone::stick;
}

/// Other snapshots of the period that ends with `last`.
std::vector<const Snapshot*> earlier_in_period(const History& history, const Snapshot& last) {
    std::vector<const Snapshot*> earlier;
    for (const Snapshot& snapshot : history.snapshots)
        if (snapshot.phase > last.phase - 1 + phase_tolerance &&
            snapshot.phase < last.phase - phase_tolerance &&
            snapshot.surface.size() == last.surface.size())
            earlier.push_back(&snapshot);
    return earlier;
}

/// The two rows on either side of the centre across `axis` (equal when one passes through it).
std::pair<int, int> middle_rows(const Surface& s, Axis axis) {
    const int across = axis == Axis::x ? 1 : 0;
    const int n = axis == Axis::x ? s.n_y : s.n_x;
    if (n == 1) return {0, 0};
    const double row = (s.offset[across] - s.first[across]) / s.spacing[across];
    // Nearer than a thousandth of a cell counts as on the row.
    const int below = std::clamp(static_cast<int>(std::floor(row + 1e-3)), 0, n - 1);
    const int above = std::clamp(static_cast<int>(std::ceil(row - 1e-3)), 0, n - 1);
    return {below, above};
}

}  // namespace

const Snapshot* last_upright(const History& history) {
    for (const Snapshot& snapshot : history.snapshots | std::views::reverse)
        if (std::abs(snapshot.phase - std::round(snapshot.phase)) < phase_tolerance)
            return &snapshot;
    return nullptr;
}

const Snapshot* snapshot_at(const History& history, double phase) {
    for (const Snapshot& snapshot : history.snapshots | std::views::reverse)
        if (std::abs(snapshot.phase - phase) < phase_tolerance) return &snapshot;
    return nullptr;
}

std::vector<Zone> zones(const History& history, const contact::FrictionLaw& friction) {
    const Snapshot* last = last_upright(history);
    if (!last) return {};
    std::vector<Zone> result(last->surface.size());
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = zone_at(last->surface, friction, i);
    for (const Snapshot* snapshot : earlier_in_period(history, *last)) {
        for (std::size_t i = 0; i < result.size(); ++i) {
            const Zone now = zone_at(snapshot->surface, friction, i);
            if (result[i] == Zone::open || result[i] == Zone::zero) continue;
            if (now == Zone::open) result[i] = Zone::zero;
            if (now == Zone::slip) result[i] = Zone::slip;
        }
    }
    return result;
}

std::optional<double> stick_half_width(const History& history,
                                       const contact::FrictionLaw& friction) {
    const Snapshot* last = last_upright(history);
    if (!last) return {};
    const Surface& s = last->surface;
    const std::vector<Zone> zone = zones(history, friction);
    const auto earlier = earlier_in_period(history, *last);
    const auto lacking = [&](int i) {
        double least = s.friction_bound[i];
        for (const Snapshot* snapshot : earlier)
            least = std::min(least, snapshot->surface.friction_bound[i]);
        return least - std::abs(s.tangential_traction_x[i]);
    };
    const auto sticks = [&](int i) { return i >= 0 && i < s.n_x && zone[i] == Zone::stick; };
    const double h = s.spacing[0];
    const int centre = static_cast<int>(std::lround((s.offset[0] - s.first[0]) / h));
    if (!sticks(centre)) return 0;
    double width = 0;
    for (const int side : {-1, 1}) {
        int outermost = centre;
        while (sticks(outermost + side)) outermost += side;
        const double x = std::abs(s.x(outermost) - s.offset[0]);
        const double d = lacking(outermost), inner = lacking(outermost - side);
        width += outermost != centre && inner > d
                     ? std::min(x + h, std::sqrt(x * x + h * (2 * x - h) * d * d /
                                                             ((inner - d) * (inner + d))))
                     : x + h / 2;
    }
    return width / 2;
}

double drawn_pressure(const contact::Case& c, const contact::Scales& scales) {
    if (!contact::has_conical_tip(c)) return scales.peak_pressure;
    const double a = scales.contact_radius;
    return scales.normal_force / (std::numbers::pi * a * a);
}

std::string drawn_bound_symbol(const contact::Case& c) {
    const std::string pressure = contact::has_conical_tip(c) ? "p_m" : "p_0";
    return c.friction.is_coulomb() ? "μ " + pressure : "τ(" + pressure + ")";
}

CentreLine centre_line(const History& history, const contact::FrictionLaw& friction, Axis axis,
                       std::optional<double> pressure) {
    CentreLine line;
    const Snapshot* snapshot = last_upright(history);
    if (!snapshot) return line;
    const Surface& s = snapshot->surface;
    const std::vector<Zone> zone = zones(history, friction);
    // An axisymmetric line layout has only its own axis to read from.
    const Axis along = s.layout == Surface::Layout::line ? Axis::x : axis;
    const auto [below, above] = middle_rows(s, along);
    const double p0 = pressure.value_or(history.scales.peak_pressure);
    const int n = along == Axis::x ? s.n_x : s.n_y;
    for (int k = 0; k < n; ++k) {
        const auto index = [&](int row) {
            const int i = along == Axis::x ? k : row, j = along == Axis::x ? row : k;
            return static_cast<std::size_t>(j) * s.n_x + i;
        };
        const std::size_t lower = index(below), upper = index(above);
        const auto mean = [&](const std::vector<double>& v) { return (v[lower] + v[upper]) / 2; };
        const double position = along == Axis::x ? s.x(k) - s.offset[0] : s.y(k) - s.offset[1];
        line.position.push_back(position / history.scales.contact_radius);
        line.traction.push_back(mean(s.tangential_traction_x) / friction.bound(p0));
        line.zone.push_back(zone[lower]);
    }
    return line;
}

std::vector<Stretch> stretches(const CentreLine& line) {
    std::vector<Stretch> result;
    const std::size_t n = line.position.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double begin =
            i == 0 ? line.position[i] : (line.position[i - 1] + line.position[i]) / 2;
        const double end =
            i + 1 == n ? line.position[i] : (line.position[i] + line.position[i + 1]) / 2;
        if (!result.empty() && result.back().zone == line.zone[i])
            result.back().end = end;
        else
            result.push_back({line.zone[i], begin, end});
    }
    return result;
}

}  // namespace tricontact::comparisons
