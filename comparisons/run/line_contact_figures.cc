#include <algorithm>
#include <array>
#include <cmath>

#include "comparisons/quantities/reference.h"
#include "comparisons/quantities/surface_fields.h"
#include "comparisons/run/figures.h"
#include "contact/bodies/half_space_scales.h"
#include "theory/oscillating_cylinder.h"

namespace tricontact::comparisons {

namespace {

using contact::Surface;

constexpr std::size_t most_line_points = 400;  // per curve: more than the picture resolves
constexpr int exact_points = 200;
constexpr double margin = 1.12;  // of the figure beside the path

/// Half width of the figure, over a: all that the contact passes.
double view(const Histories& histories) {
    double w = 0;
    for (const contact::History& history : histories) w = std::max(w, amplitude_ratio(history));
    return margin * (1 + w);
}

report::FigureAxis position_axis(double half_view) {
    return {.label = "position x/a", .low = -half_view, .high = half_view};
}

/// Adds values over `unit` on the row's points, positions over a, within the figure.
void add_row(const Surface& s, const std::vector<double>& values, double a, double unit,
             double half_view, report::Curve& curve) {
    for (const std::size_t i : report::thinned(s.size(), most_line_points)) {
        const double x = s.x(static_cast<int>(i)) / a;
        if (std::abs(x) <= half_view) curve.add(x, values[i] / unit);
    }
}

Figures turning_figures(const contact::Case& c, const Histories& histories) {
    constexpr std::array<double, 2> before_upright{0.75, 0.25};  // turning points, in periods
    const double half_view = view(histories);
    report::Figure figure{
        .id = "turning_points",
        .title = "Pressure at the turning points (as figure 3.38 (a) of the thesis)",
        .caption =
            "In the last period, positions on the substrate. What lies under both curves "
            "is in contact throughout; the lower of them bounds the traction that can "
            "stay.",
        .x = position_axis(half_view),
        .y = {"pressure p / p_0"}};
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::History& history = histories[i];
        const contact::Snapshot* last = last_upright(history);
        if (!last) continue;
        for (const double before : before_upright) {
            const contact::Snapshot* turn = snapshot_at(history, last->phase - before);
            if (!turn) continue;
            report::Curve& curve = figure.curves.emplace_back(curve_of(history, i));
            add_row(turn->surface, turn->surface.normal_traction, history.scales.contact_radius,
                    history.scales.peak_pressure, half_view, curve);
        }
    }
    if (figure.curves.empty()) return {};
    const Reference r = reference(c);
    if (constant_loads(c))
        for (const double turn : {-r.amplitude_ratio, r.amplitude_ratio})
            figure.curves.emplace_back(report::Curve{.name = "Hertz (3.5.15)", .theory = true})
                .sample(-half_view, half_view, exact_points, [&](double x) {
                    return std::sqrt(std::max(0., 1 - (x - turn) * (x - turn)));
                });
    return {figure};
}

/// Adds u_x/U_max of the half-space, where it is known.
void add_exact_displacement(const contact::Case& c, double half_view, report::Figure& figure) {
    const Reference r = reference(c);
    const auto stick = c.rolling ? r.stick_ratio
                       : in_unit_range(r.tangential_ratio)
                           ? theory::line_stick_half_width(0, r.tangential_ratio)
                           : std::nullopt;
    if (!stick || !(*stick > 0)) return;
    const double lambda =
        contact::line_shift_factor(c.materials(), c.indenter.length / r.hertz.contact_radius);
    const double w = c.rolling ? r.amplitude_ratio : 0;
    figure.curves.emplace_back(report::Curve{.name = "exact, half-space", .theory = true})
        .sample(-half_view, half_view, exact_points, [&](double x) {
            return theory::line_shakedown_displacement(x, w, *stick, lambda);
        });
}

Figures displacement_figures(const contact::Case& c, const Histories& histories) {
    const double half_view = view(histories);
    report::Figure figure{
        .id = "displacement",
        .title = "Tangential displacement of the surface (as figure 3.39 of the thesis)",
        .caption =
            "The last upright state. What has stuck since the load came is displaced as "
            "one, by the shift of the indenter. a and U_max are each model's own.",
        .x = position_axis(half_view),
        .y = {"displacement u_x / U_max"}};
    for (std::size_t i = 0; i < histories.size(); ++i) {
        const contact::Snapshot* last = last_upright(histories[i]);
        if (!last) continue;
        const contact::Scales& scales = histories[i].scales;
        add_row(last->surface, last->surface.displacement_x, scales.contact_radius,
                scales.unit_shift, half_view,
                figure.curves.emplace_back(curve_of(histories[i], i)));
    }
    if (figure.curves.empty()) return {};
    add_exact_displacement(c, half_view, figure);
    return {figure};
}

}  // namespace

Figures line_contact_figures(const contact::Case& c, const Histories& histories) {
    Figures figures = turning_figures(c, histories);
    for (report::Figure& figure : displacement_figures(c, histories)) figures.push_back(figure);
    return figures;
}

}  // namespace tricontact::comparisons
