#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "comparisons/quantities/resample.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "report/format.h"

namespace tricontact::comparisons {

namespace {

using contact::operator/;
using contact::ContactState;
using contact::History;
using contact::Snapshot;
using contact::Surface;

/// Loading, first turning point, third turning point of the third period, end (thesis figures 3.7
/// and 3.19); what was not run is replaced by the last period's or left out.
std::vector<const Snapshot*> chosen_instants(const History& history) {
    const Snapshot* last = last_upright(history);
    if (!last) return {};
    const Snapshot* third = snapshot_at(history, 2.75);
    if (!third) third = snapshot_at(history, last->phase - 0.25);
    std::vector<const Snapshot*> chosen;
    for (const Snapshot* snapshot :
         {snapshot_at(history, 0), snapshot_at(history, 0.25), third, last})
        if (snapshot && (chosen.empty() || snapshot->phase > chosen.back()->phase))
            chosen.push_back(snapshot);
    return chosen;
}

/// Outline of the contact on the half-space, half widths and centre over a.
report::Curve ellipse(const contact::Vector2& half, const contact::Vector2& centre) {
    constexpr int n = 180;
    report::Curve curve;
    for (int i = 0; i <= n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        curve.add(centre[0] + half[0] * std::cos(angle), centre[1] + half[1] * std::sin(angle));
    }
    return curve;
}

/// On a grid finer than the picture one cell stands for a block of `stride` x `stride`.
report::Panel zone_panel(const Snapshot& snapshot, double a, const contact::Vector2& half,
                         const report::FigureAxis& x_axis, const report::FigureAxis& y_axis) {
    constexpr int most_cells = 128;  // in each direction: a panel has 216 pixels
    const Surface& s = snapshot.surface;
    const auto inside = [a](double value, const report::FigureAxis& axis, double spacing) {
        return std::abs(value) / a <= *axis.high + spacing / a;
    };
    const int stride = std::max(1, (std::max(s.n_x, s.n_y) + most_cells - 1) / most_cells);
    std::vector<int> columns;
    for (int i = 0; i < s.n_x; i += stride)
        if (inside(s.x(i), x_axis, s.spacing[0])) columns.push_back(i);
    report::Panel panel{
        .title = fmt::format("n = {:.6g}", snapshot.phase), .x = {}, .y = {}, .kinds = {}};
    for (const int i : columns) panel.x.push_back(s.x(i) / a);
    for (int j = 0; j < s.n_y; j += stride) {
        if (!inside(s.y(j), y_axis, s.spacing[1])) continue;
        panel.y.push_back(s.y(j) / a);
        for (const int i : columns) {
            const ContactState state = s.contact_state[static_cast<std::size_t>(j) * s.n_x + i];
            panel.kinds.push_back(state == ContactState::stick  ? 0
                                  : state == ContactState::slip ? 1
                                                                : -1);
        }
    }
    panel.curves = {ellipse(half, {0, 0}), ellipse(half, {s.offset[0] / a, s.offset[1] / a})};
    panel.curves[0].theory = true;
    panel.curves[1].colour = 0;
    return panel;
}

report::Figure zone_figure(const contact::Case& c, const History& history) {
    const std::vector<const Snapshot*> instants = chosen_instants(history);
    const double a = history.scales.contact_radius;
    double reach_x = 0, reach_y = 0;
    for (const Snapshot* snapshot : instants) {
        reach_x = std::max(reach_x, std::abs(snapshot->surface.offset[0]) / a);
        reach_y = std::max(reach_y, std::abs(snapshot->surface.offset[1]) / a);
    }
    const contact::HalfSpaceScales scales = contact::half_space_scales(c);
    const contact::Vector2 half = scales.half_widths / scales.contact_radius;
    const double half_x = 1.12 * half[0] + reach_x, half_y = 1.12 * half[1] + reach_y;
    const bool nothing_slips =
        history.verdict.state == contact::State::shakedown && history.steps.back().slip_area == 0;
    report::Figure figure{
        .id = "zones_" + history.model,
        .title = "Stick and slip, " + report::display_name(history.model),
        .caption =
            std::string("Dark blue: stick; amber: slip; as the background: open. Outlines: a, or "
                        "the half axes of an ellipse, upright (dashed) and under the "
                        "indenter's present position (red).") +
            (nothing_slips ? " At the last instant of a shaken-down contact nothing slips any more."
                           : ""),
        .x = {.label = "x/a", .low = -half_x, .high = half_x},
        .y = {.label = "y/a", .low = -half_y, .high = half_y},
        .kinds = zone_kinds(),
        .equal_scales = true};
    for (const Snapshot* snapshot : instants)
        figure.panels.push_back(zone_panel(*snapshot, a, half, figure.x, figure.y));
    return figure;
}

constexpr double drawn_half_width = 1.15;

/// Indices of the points within the map along one direction, thinned and symmetric to the centre.
std::vector<int> visible(int n, double first, double spacing, double a) {
    constexpr int most_points = 60;  // more are not seen
    const int middle = std::clamp(static_cast<int>(std::lround(-first / spacing)), 0, n - 1);
    const int reach = static_cast<int>(std::ceil(drawn_half_width * a / spacing));
    const int stride = std::max(1, (2 * reach + most_points - 1) / most_points);
    std::vector<int> indices;
    for (int i = middle - reach / stride * stride; i <= middle + reach; i += stride)
        if (i >= 0 && i < n) indices.push_back(i);
    return indices;
}

/// A field over `unit` on the grid around the indenter, positions over a.
report::ContourMap map_of(const Surface& s, const std::vector<double>& values, double a,
                          double unit, const std::string& label) {
    report::ContourMap map{.label = label, .x = {}, .y = {}, .values = {}};
    const std::vector<int> columns = visible(s.n_x, s.first[0] - s.offset[0], s.spacing[0], a);
    for (const int i : columns) map.x.push_back((s.x(i) - s.offset[0]) / a);
    for (const int j : visible(s.n_y, s.first[1] - s.offset[1], s.spacing[1], a)) {
        map.y.push_back((s.y(j) - s.offset[1]) / a);
        for (const int i : columns)
            map.values.push_back(values[static_cast<std::size_t>(j) * s.n_x + i] / unit);
    }
    return map;
}

}  // namespace

Figures zone_figures(const contact::Case& c, const Histories& histories) {
    Figures figures;
    for (const History& history : histories) {
        const Snapshot* last = last_upright(history);
        if (last && is_grid(last->surface)) figures.push_back(zone_figure(c, history));
    }
    return figures;
}

Figures surface_figures(const contact::Case& c, const Histories& histories) {
    Figures figures;
    for (const History& history : histories) {
        const Snapshot* last = last_upright(history);
        if (!last || !is_grid(last->surface)) continue;
        const Surface& s = last->surface;
        const contact::Scales& scales = history.scales;
        const std::string model = report::display_name(history.model);
        const auto add = [&](const std::string& id, const std::string& title,
                             const std::string& caption, const std::vector<double>& values,
                             double unit, const std::string& label) {
            figures.push_back(
                {.id = id + history.model,
                 .title = title + model,
                 .caption = caption + ", the component along the load, in the last upright state.",
                 .x = {.label = "x/a", .low = -drawn_half_width, .high = drawn_half_width},
                 .y = {.label = "y/a", .low = -drawn_half_width, .high = drawn_half_width},
                 .map = map_of(s, values, scales.contact_radius, unit, label),
                 .equal_scales = true});
        };
        const std::string bound = drawn_bound_symbol(c);
        add("traction_surface_", "Traction over the contact, ", fmt::format("τ_x/({})", bound),
            s.tangential_traction_x, c.friction.law()->bound(drawn_pressure(c, scales)),
            fmt::format("τ_x / ({})", bound));
        add("displacement_surface_", "Displacement of the surface, ", "u_x/U_max", s.displacement_x,
            scales.unit_shift, "u_x / U_max");
    }
    return figures;
}

}  // namespace tricontact::comparisons
